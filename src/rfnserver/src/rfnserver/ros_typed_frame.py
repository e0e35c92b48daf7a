"""The filled frame that a callback gets: the message of 2012, with the typed arguments of its elements."""

from typing import Any, Callable, Set, Tuple

import rospy
from roboframenet_msgs.msg import FilledFrameElement, FilledSemanticFrame

from typed_arguments import TypedArgument, from_goal_text


class TypedFrame(FilledSemanticFrame):
    """A ``FilledSemanticFrame`` whose elements can be asked for their meaning::

        frame["goal"].relation == "under"
        frame["angle"].si  # radians
        "theme" in frame

    An element that nobody filled gives an argument with an empty text. A client of 2012 sends only texts; then each
    argument has only its text, and ``si`` is None.

    Attributes:
        arguments: typed arguments in the order of the elements
    """

    def __init__(self, frame: FilledSemanticFrame, arguments: Tuple[TypedArgument, ...]) -> None:
        super().__init__(frame.name, frame.frame_elements, frame.action_server_topics)
        self.arguments = arguments

    def __getitem__(self, element: str) -> TypedArgument:
        return next((argument for argument in self.arguments if argument.name == element), TypedArgument(name=element))

    def __contains__(self, element: str) -> bool:
        return any(argument.name == element and argument.text for argument in self.arguments)

    def __eq__(self, other: Any) -> bool:
        """Whether two messages are equal; one of them may have no typed arguments."""
        if not isinstance(other, FilledSemanticFrame):
            return NotImplemented
        return all(getattr(self, field) == getattr(other, field) for field in FilledSemanticFrame.__slots__)

    __hash__ = None  # type: ignore[assignment]  # as for every message: its fields may change


class NotedFrame(TypedFrame):
    """A frame that notes which elements are read: by ``frame["goal"]``, or as ``argument`` of its frame elements.

    Whoever takes ``arguments``, or makes a dictionary of all elements, has read all. ``"goal" in frame``, and writing
    the frame into a log, reads nothing.

    Attributes:
        read: names of the elements that were read
    """

    def __init__(self, frame: TypedFrame) -> None:
        self.read: Set[str] = set()
        self._arguments = frame.arguments
        super().__init__(frame, frame.arguments)
        self._plain = frame
        self.frame_elements = [_NotedElement(element, self.read.add) for element in frame.frame_elements]

    @property  # type: ignore[override]
    def arguments(self) -> Tuple[TypedArgument, ...]:
        self.read.update(argument.name for argument in self._arguments)
        return self._arguments

    @arguments.setter
    def arguments(self, arguments: Tuple[TypedArgument, ...]) -> None:
        self._arguments = arguments

    def __getitem__(self, element: str) -> TypedArgument:
        self.read.add(element)
        return self._plain[element]

    def __contains__(self, element: str) -> bool:
        return element in self._plain

    def __str__(self) -> str:
        return str(self._plain)

    __repr__ = __str__


class _NotedElement(FilledFrameElement):
    """An element that tells when its argument is read."""

    def __init__(self, element: FilledFrameElement, note: Callable[[str], None]) -> None:
        # The constructor of a message reads its fields.
        self._note: Callable[[str], None] = lambda _name: None
        super().__init__(element.name, element.argument)
        self._note = note

    def __getattribute__(self, attribute: str) -> Any:
        if attribute == "argument":
            object.__getattribute__(self, "_note")(self.name)
        return object.__getattribute__(self, attribute)

    def __eq__(self, other: Any) -> bool:
        if not isinstance(other, FilledFrameElement):
            return NotImplemented
        return (self.name, self.argument) == (other.name, other.argument)

    __hash__ = None  # type: ignore[assignment]  # as for every message


def typed_frame(action_goal: Any) -> TypedFrame:
    """Return the frame of a goal with its typed arguments.

    Args:
        action_goal: a FilledSemanticFrameActionGoal, as a goal handle holds it
    """
    frame = action_goal.goal.frame
    elements = [(element.name, element.argument) for element in frame.frame_elements]
    found = from_goal_text(action_goal.header.frame_id, elements)
    if found.reason:
        rospy.logwarn("frame %s: %s", frame.name, found.reason)
    return TypedFrame(frame, found.arguments)
