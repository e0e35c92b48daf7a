"""An action server that registers for semantic frames."""
