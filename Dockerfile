# Two stages: the same steps as `make run`, then only what runs. Not root; recordings go to the volume.
FROM python:3.11-slim AS build
WORKDIR /heft
COPY requirements.txt pyproject.toml README.md ./
COPY core core
COPY cells cells
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
ENTRYPOINT ["heft"]
CMD ["run", "lwr4_bench", "--payload", "steel_block"]
