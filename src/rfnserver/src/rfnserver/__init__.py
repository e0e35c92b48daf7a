"""An action server that registers for semantic frames."""
from rfnserver.rfnserver import RFNServer

__all__ = ["RFNServer"]
