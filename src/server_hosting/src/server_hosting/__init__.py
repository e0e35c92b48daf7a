"""Many RFNServers in one process, and servers that are started when a command needs them."""
