"""Binds semantic frames to action servers, services and topics that nobody may edit, by YAML."""
