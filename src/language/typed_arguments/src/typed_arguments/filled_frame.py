"""A filled semantic frame: its name, its arguments, and the server that carries it out."""

from dataclasses import dataclass
from typing import Optional, Tuple

from typed_arguments.argument import TypedArgument


@dataclass(frozen=True)
class FilledFrame:
    """A frame whose elements have arguments.

    Attributes:
        name: name of the frame
        arguments: in the order of the frame's file; elements without one are left out
        server: name of the action server that carries it out; empty while none is chosen
    """

    name: str
    arguments: Tuple[TypedArgument, ...] = ()
    server: str = ""

    @property
    def texts(self) -> Tuple[Tuple[str, str], ...]:
        """The name and the text of each argument, which is what a client of 2012 knows."""
        return tuple((argument.name, argument.text) for argument in self.arguments)

    def find(self, element: str) -> Optional[TypedArgument]:
        """Return the argument of an element; None if it has none."""
        return next((argument for argument in self.arguments if argument.name == element), None)

    def text(self, element: str) -> str:
        """Return the text of an element's argument; empty if it has none."""
        found = self.find(element)
        return "" if found is None else found.text
