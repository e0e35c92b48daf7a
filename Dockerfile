# docker build -t roboframenet . && docker run --rm -it --network host roboframenet
# The host's network, because ROS nodes open ports of their own. Another command: docker run ... roboframenet make demo
# Only the page, with a file that holds a secret of at least 16 characters (http://127.0.0.1:8080/?token=SECRET):
#   docker run --rm -it -p 127.0.0.1:8080:8080 -v "$PWD/token:/token:ro" roboframenet \
#     scripts/run console_address:=0.0.0.0 console_token_file:=/token
# The other release: docker build --build-arg RELEASE=13 ...
# Noetic, which has not been tried: docker build --build-arg BASE=ros:noetic-ros-base ...
ARG RELEASE=12
ARG BASE=debian:$RELEASE
FROM $BASE
ARG PIP_INDEX_URL PIP_EXTRA_INDEX_URL
RUN apt-get update && apt-get install -y --no-install-recommends make && rm -rf /var/lib/apt/lists/*
WORKDIR /roboframenet
# The environment first: it changes less often than the code.
COPY Makefile requirements*.txt ./
COPY scripts scripts
RUN make setup
COPY . .
RUN make build
CMD ["make", "run"]
