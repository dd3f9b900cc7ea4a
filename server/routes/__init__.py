"""The HTTP interface, one router per noun."""

from fastapi import APIRouter

from server.routes import (
    about,
    accounts,
    audit,
    cells,
    control,
    diagnoses,
    keys,
    live,
    runs,
    session,
    trials,
    twins,
    viewer,
    webhooks,
    zones,
)

ROUTERS: tuple[APIRouter, ...] = (
    about.router,
    session.router,
    accounts.router,
    keys.router,
    audit.router,
    cells.router,
    zones.router,
    twins.router,
    control.router,
    runs.router,
    live.router,
    diagnoses.router,
    trials.router,
    webhooks.router,
    viewer.router,
)
