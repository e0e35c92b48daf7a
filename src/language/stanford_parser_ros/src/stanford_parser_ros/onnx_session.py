"""Networks in ONNX Runtime."""

from pathlib import Path
from typing import Any

from stanford_parser_ros.model_error import ModelError


def onnx_session(network: Path, *, threads: int = 1) -> Any:
    """Load a network.

    Args:
        network: its file; ONNX Runtime reads it with less memory than its bytes
        threads: that compute it
    Raises:
        ModelError: it cannot be loaded, or ONNX Runtime is not installed
    """
    try:
        import onnxruntime
    except ImportError as error:
        raise ModelError(
            f"ONNX Runtime is not installed ({error}): run 'make setup' in RoboFrameNet's clone, "
            "and build with -DPYTHON_EXECUTABLE=CLONE/.venv/bin/python"
        ) from error
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    options.inter_op_num_threads = 1
    # An arena would keep the memory of the longest text.
    options.enable_cpu_mem_arena = False
    options.log_severity_level = 3
    try:
        return onnxruntime.InferenceSession(str(network), options, providers=["CPUExecutionProvider"])
    except Exception as error:  # boundary: ONNX Runtime raises many kinds of errors for a file that it cannot read
        raise ModelError(f"ONNX Runtime cannot load {network}: {type(error).__name__}: {error}") from error
