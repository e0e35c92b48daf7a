"""Binds semantic frames to existing action servers, services and topics, in YAML."""
