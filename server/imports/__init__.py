"""Logs of other programs on their way to a recording: what was sent, what they are taken for, what has to be answered; their routes."""
