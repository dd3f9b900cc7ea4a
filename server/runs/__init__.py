"""Runs: who is in control, order, plan, release, steps, stops, recording, result, webhooks; their tables, schemas and routes."""
