"""The procedure from top to bottom, on a robot session: identify a payload, or carry out a proposed experiment."""
