# Debian 12 with the Python package, the program inside it, and what draws its figures.
#   docker build -t signorini .                                      builds, and runs the suite smoke
#   docker run --rm signorini solve sdof-stop --method exact-orbit
FROM debian:12-slim AS build
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates patchelf python3-pip python3-setuptools \
      python3-wheel
COPY . /signorini
WORKDIR /signorini
RUN ./bench run smoke --out /tmp/smoke && sh cmake/release/packages.sh build/release /packages wheel

FROM debian:12-slim
COPY --from=build /packages /packages
RUN apt-get update && apt-get install -y --no-install-recommends gnuplot-nox python3-numpy python3-venv && rm -rf /var/lib/apt/lists/* \
    && python3 -m venv --system-site-packages /opt/signorini-python \
    && /opt/signorini-python/bin/pip install --no-index /packages/signorini-*.whl \
    && ln -s /opt/signorini-python/bin/signorini /usr/local/bin/signorini
ENTRYPOINT ["signorini"]
