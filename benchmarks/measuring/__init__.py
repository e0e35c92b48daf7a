"""What the benchmarks share: graphs of their own, and what is measured in them."""
