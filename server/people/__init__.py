"""Accounts, keys, sessions, roles and what each may do, the audit chain; the door that every request goes through; their routes."""
