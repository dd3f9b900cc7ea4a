"""What Prometheus reads."""

from __future__ import annotations

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, generate_latest

CONTENT_TYPE = "text/plain; version=0.0.4; charset=utf-8"


class Metrics:
    """The service's metrics, in a registry of their own."""

    def __init__(self) -> None:
        self.registry = CollectorRegistry()
        labels = ("method", "route", "status")
        self.requests = Counter("heft_requests_total", "Requests answered.", labels, registry=self.registry)
        self.seconds = Histogram("heft_request_seconds", "Seconds until a request was answered.", labels[:2], registry=self.registry)
        self.sign_ins = Counter("heft_sign_ins_total", "Sign-ins.", ("outcome",), registry=self.registry)
        self.cells_checked = Counter("heft_cells_checked_total", "Uploaded cells.", ("outcome",), registry=self.registry)
        self.started = Gauge("heft_start_time_seconds", "When the service started, Unix time.", registry=self.registry)
        self.started.set_to_current_time()

    def text(self) -> bytes:
        """All of them, in Prometheus's text format."""
        return generate_latest(self.registry)
