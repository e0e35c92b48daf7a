"""Parameters of the node."""

from dataclasses import dataclass

from roboframenet_ros.parameters import Parameters, parameter

#: Where streamable HTTP is served: agents of this machine only.
ADDRESS = "127.0.0.1"


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        port: of the server for streamable HTTP on 127.0.0.1; 0: any
        token_file: file with the secret that a client must know; it is needed for HTTP
        niceness: how much less processor time than the stages the node gets when it is scarce, as of nice(1)

    Raises:
        ParameterError: a value out of its range
    """

    port: int = parameter(8765, least=0, most=65535)
    token_file: str = parameter("")
    niceness: int = parameter(5, least=0, most=19)
