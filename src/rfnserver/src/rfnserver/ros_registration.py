"""Keeps a server known to the registrar and the framer, also when they restart."""

import os
import threading
from typing import Any, Callable, Dict, List, Optional, Set, Tuple

import rospy
from roboframenet_msgs.msg import FrameCatalogue, Lexicon
from roboframenet_msgs.srv import AddFrame, AddLexicalUnit, RegisterWithFrame

from rfnserver.wishes import Knowledge, Wish, WishKind, forgotten
from roboframenet_ros.ros_service import ServiceError, call_service

#: How long a call waits for its service, and then for the answer, seconds.
SERVICE_TIMEOUT_S = 5.0
#: A wish that was refused is not tried again before so long, unless the other side restarts; seconds.
RETRY_S = 10.0

FrameCheck = Callable[[str], Tuple[bool, str]]


class Registration:
    """The wishes of one server, and a thread that sees to them.

    Subscribes:
        frame_catalogue, lexicon (latched): tell when registrar or framer restarted and what they know
    Services:
        add_frame, add_lexical_unit, register_with_frame: called
    """

    def __init__(self, server_name: str, *, check: Optional[FrameCheck] = None) -> None:
        """
        Args:
            server_name: name of the action server, as it is registered
            check: says whether a frame is known by now, and why this server cannot carry it out, empty when it can
        """
        self._server_name = server_name
        self._check = check
        #: Frames that were registered before their file was there: they are checked when it comes.
        self._unchecked: Set[str] = set()
        self._condition = threading.Condition()
        self._wishes: List[Wish] = []
        self._registrar: Optional[Knowledge] = None
        self._framer: Optional[Knowledge] = None
        self._reported: Dict[Wish, str] = {}
        self._is_stale = False
        self._is_closed = False
        self._thread: Optional[threading.Thread] = None
        self._subscribers: Tuple[rospy.Subscriber, ...] = ()
        #: Why the last call failed; empty after one that succeeded.
        self.last_error = ""

    def want(self, kind: WishKind, subject: str) -> bool:
        """Ask for something now, and again whenever it is forgotten.

        Args:
            kind: what is wanted
            subject: path of a file, made absolute here, or name of a frame
        Returns:
            whether it was granted at once; if not, :attr:`last_error` says why and it is tried again later
        """
        wish = Wish(kind, subject if kind is WishKind.REGISTRATION else os.path.abspath(os.path.expanduser(subject)))
        self._watch()
        with self._condition:
            if wish not in self._wishes:
                self._wishes.append(wish)
        return self._ask(wish)

    def close(self) -> None:
        """Stop seeing to the wishes; return when the thread has ended."""
        with self._condition:
            self._is_closed = True
            self._condition.notify_all()
            thread = self._thread
        for subscriber in self._subscribers:
            subscriber.unregister()
        if thread is not None and thread is not threading.current_thread():
            thread.join(2.0 * SERVICE_TIMEOUT_S)

    def _watch(self) -> None:
        """Start to listen and to work; once, with the first wish."""
        with self._condition:
            if self._thread is not None or self._is_closed:
                return
            self._thread = threading.Thread(target=self._run, name=f"registration of {self._server_name}", daemon=True)
        self._subscribers = (
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("lexicon", Lexicon, self._on_lexicon, queue_size=1),
        )
        rospy.on_shutdown(self.close)
        self._thread.start()

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        knowledge = Knowledge(
            id=message.registrar_id,
            files=frozenset(file.path for file in message.files),
            registrations=frozenset(
                callback.frame_name for callback in message.callbacks if callback.callback_topic == self._server_name
            ),
        )
        with self._condition:
            self._registrar = knowledge
            self._is_stale = True
            self._condition.notify_all()

    def _on_lexicon(self, message: Lexicon) -> None:
        with self._condition:
            self._framer = Knowledge(id=message.framer_id, files=frozenset(file.path for file in message.files))
            self._is_stale = True
            self._condition.notify_all()

    def _run(self) -> None:
        while not rospy.is_shutdown():
            with self._condition:
                self._condition.wait_for(lambda: self._is_stale or self._is_closed, timeout=RETRY_S)
                if self._is_closed:
                    return
                self._is_stale = False
                missing = forgotten(self._wishes, registrar=self._registrar, framer=self._framer)
                unchecked = sorted(self._unchecked)
            for wish in missing:
                if self._ask(wish):
                    rospy.loginfo("%s: %s %s again", self._server_name, wish.kind.value, wish.subject)
            for frame_name in unchecked:
                self._report(Wish(WishKind.REGISTRATION, frame_name), self._find_fault(frame_name))

    def _ask(self, wish: Wish) -> bool:
        try:
            error = self._call(wish)
        except ServiceError as failure:
            error = str(failure)
        self._report(wish, error)
        return not error

    def _report(self, wish: Wish, error: str) -> None:
        """Remember an error, and log it unless it was the last one about the same wish: it is tried again and again."""
        self.last_error = error
        if error and self._reported.get(wish) != error:
            rospy.logerr("%s: %s %s: %s", self._server_name, wish.kind.value, wish.subject, error)
        self._reported[wish] = error

    def _call(self, wish: Wish) -> str:
        """Make the call; return why it was refused, empty when it was granted."""
        if wish.kind is WishKind.REGISTRATION:
            fault = self._find_fault(wish.subject)
            if fault:
                return fault
            response = call_service(
                "register_with_frame",
                RegisterWithFrame,
                timeout_s=SERVICE_TIMEOUT_S,
                frame_name=wish.subject,
                callback_topic=self._server_name,
            )
            return "" if response.success else "; ".join(response.error) or "refused"
        service: Any = AddFrame if wish.kind is WishKind.FRAME_FILE else AddLexicalUnit
        response = call_service(wish.kind.value, service, timeout_s=SERVICE_TIMEOUT_S, absolute_file_path=wish.subject)
        return "" if response.success else "the file was refused; the topic file_problems says why"

    def _find_fault(self, frame_name: str) -> str:
        """Return why this server cannot carry out a frame; one that is not known yet is looked at again when it is."""
        if self._check is None:
            return ""
        is_known, fault = self._check(frame_name)
        with self._condition:
            if is_known:
                self._unchecked.discard(frame_name)
            else:
                self._unchecked.add(frame_name)
        return fault
