# SPDX-License-Identifier: LGPL-2.1-or-later
#
# docker build -t seiche .                         (Debian 12)
# docker build -t seiche --build-arg DEBIAN=13 .
# docker run --rm -v "$PWD:/work" -u "$(id -u):$(id -g)" seiche dam.prm
#
# The first stage makes the Debian packages, the second installs them on a bare
# system. contrib/package runs the same lines without Docker.
ARG DEBIAN=12

FROM debian:${DEBIAN} AS build
COPY contrib/packages.txt /seiche/contrib/packages.txt
RUN apt-get update
RUN apt-get install -y --no-install-recommends dpkg-dev file help2man $(sed 's/ *#.*//' /seiche/contrib/packages.txt)
COPY . /seiche
WORKDIR /seiche
RUN cmake --preset package
RUN cmake --build build-package
RUN cd build-package && rm -f *.deb && cpack

FROM debian:${DEBIAN}-slim AS seiche
COPY --from=build /seiche/build-package/*.deb /packages/
RUN apt-get update
RUN apt-get install -y --no-install-recommends /packages/seiche_*.deb
WORKDIR /work
ENTRYPOINT ["seiche"]
