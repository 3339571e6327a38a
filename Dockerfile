# Debian 12 with the program, its Python package and what they need.
#   docker build -t signorini .                                      builds, and runs the suite smoke
#   docker run --rm signorini solve sdof-stop --method exact-orbit
FROM debian:12-slim
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates python3-numpy python3-pip python3-setuptools \
      python3-venv python3-wheel && rm -rf /var/lib/apt/lists/*
COPY . /signorini
WORKDIR /signorini
RUN ./bench run smoke --out /tmp/smoke \
    && ln -s /signorini/build/release/harness/signorini /usr/local/bin/signorini \
    && python3 -m venv --system-site-packages /opt/signorini-python \
    && /opt/signorini-python/bin/pip install --no-build-isolation ./python \
    && /opt/signorini-python/bin/python -c 'import signorini; assert signorini.Scene.load("sdof-stop").solve().certified'
ENTRYPOINT ["signorini"]
