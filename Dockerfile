# docker build -t roboframenet . && docker run --rm -it --network host roboframenet
# The host's network, because ROS nodes open ports of their own. Another command: docker run ... roboframenet make demo
FROM debian:12
RUN apt-get update && apt-get install -y --no-install-recommends make && rm -rf /var/lib/apt/lists/*
WORKDIR /roboframenet
# The environment first: it changes less often than the code.
COPY Makefile requirements*.txt ./
COPY scripts scripts
RUN make setup
COPY . .
RUN make build
CMD ["make", "run"]
