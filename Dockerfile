# Three stages: the console and the service by the same steps as `make run`, then only what runs. Not root; recordings go to the volume.
FROM node:22-slim AS console
WORKDIR /heft/web
COPY web/package.json web/package-lock.json web/.npmrc ./
RUN npm ci
COPY core/words ../core/words
COPY docs/*.md ../docs/
COPY web ./
RUN npm run build

FROM python:3.11-slim AS build
WORKDIR /heft
COPY requirements.txt pyproject.toml README.md ./
COPY core core
COPY cells cells
COPY server server
COPY --from=console /heft/web/dist server/console
RUN python -m venv .venv \
    && .venv/bin/python -m pip install --no-cache-dir -r requirements.txt \
    && .venv/bin/python -m pip install --no-cache-dir --no-deps .

FROM python:3.11-slim
RUN useradd --create-home --uid 10001 heft && mkdir -p /data && chown heft /data
COPY --from=build --chown=heft /heft /heft
ENV PATH=/heft/.venv/bin:$PATH MPLBACKEND=Agg NUMBA_CACHE_DIR=/data/numba
USER heft
WORKDIR /data
VOLUME /data
EXPOSE 8000
HEALTHCHECK --interval=10s --timeout=5s --start-period=30s \
    CMD ["python", "-c", "import urllib.request; urllib.request.urlopen('http://127.0.0.1:8000/health', timeout=4)"]
ENTRYPOINT ["heft"]
CMD ["serve", "--host", "0.0.0.0", "--data", "/data"]
