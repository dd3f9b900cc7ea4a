"""Alembic's entry: migrates the connection that `server.store.store` hands over."""

from __future__ import annotations

from alembic import context

from server.store.store import Table

context.configure(connection=context.config.attributes["connection"], target_metadata=Table.metadata, transactional_ddl=False)
context.run_migrations()
