"""Many RFNServers in one process, and servers that start on demand."""
