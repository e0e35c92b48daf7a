"""Connects a node to publishers that rospy has missed."""

import threading
import time
import xmlrpc.client
from collections import Counter
from typing import FrozenSet, Set, Tuple

import rospy
from rospy.impl.registration import (
    Registration,
    RegistrationListener,
    get_registration_listeners,
    get_topic_manager,
)

from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
from roboframenet_ros.ros_publishing import is_shutting_down
from roboframenet_ros.ros_server_links import is_agreed
from roboframenet_ros.timed_transport import TimedTransport

#: Time between two looks, seconds; who is not heard in both was missed.
_LOOK_S = 1.0
_ANSWER_TIMEOUT_S = 1.0
#: A publisher that was killed stays known to the master: it is tried so often.
_MOST_TRIES = 3
#: Time between two looks at whom this node has ceased to hear, seconds. It asks nobody.
_LOST_LOOK_S = 5.0

#: A topic, and the XML-RPC address of a node that publishes it.
Link = Tuple[str, str]


def connect_missed_publishers() -> None:
    """Have a thread look after the subscriptions of this node; call it after ``rospy.init_node``, once or more."""
    listeners = get_registration_listeners()
    if not any(isinstance(listener, MissedPublishers) for listener in listeners.listeners):
        listeners.add_listener(MissedPublishers())


class MissedPublishers(RegistrationListener):  # type: ignore[misc]
    """Looks whether the node hears everybody who publishes its topics: after each subscription, and each loss.

    The master answers a subscription with those who publish the topic, and tells of everybody who comes later. rospy
    keeps the list that it read last: where a publisher comes while the answer is on its way, the answer takes the place
    of what the master told later, and the two are never connected. And where a publisher refuses a connection, because
    it ends and begins to publish just then, rospy does not try again, though it counts the connection for a second
    more. Where several publishers of a topic begin anew at once, rospy connects twice to one of them: the publisher and
    the subscriber each drop one of the two connections, and not the same one. A stage waits for ever for what another
    one sends.
    """

    def __init__(self) -> None:
        """Begin; the subscriptions that are there count as new."""
        self._master = TimedMaster(timeout_s=_ANSWER_TIMEOUT_S)
        self._tries: Counter[Link] = Counter()
        self._is_changed = threading.Event()
        self._is_changed.set()
        # A daemon: it holds nothing that must be closed.
        threading.Thread(target=self._work, name="missed_publishers", daemon=True).start()

    def reg_added(self, resolved_name: str, data_type_or_uri: str, reg_type: str) -> None:
        """Look at the subscriptions soon; rospy calls it for each new topic and service."""
        if reg_type == Registration.SUB:
            self._is_changed.set()

    def _work(self) -> None:
        unheard: FrozenSet[Link] = frozenset()
        heard: FrozenSet[Link] = frozenset()
        while not is_shutting_down():
            is_new = self._is_changed.wait(_LOST_LOOK_S)
            still = _links()
            if not is_new and heard <= still:
                heard = still
                continue
            time.sleep(_LOOK_S)
            self._is_changed.clear()
            heard = _links()
            # Who has just begun to publish is not missed yet.
            before = unheard
            try:
                unheard = self._unheard()
                self._connect(unheard & before)
            except (*NO_ANSWER, IndexError, TypeError, ValueError) as error:
                rospy.logdebug("cannot tell which publishers this node misses: %s", error)
            if unheard:
                self._is_changed.set()

    def _unheard(self) -> FrozenSet[Link]:
        """Return those whom this node should hear and does not."""
        name = rospy.get_name()
        state = self._master.system_state()
        unheard: Set[Link] = set()
        for topic, publishers in state.publishers.items():
            if name not in state.subscribers.get(topic, ()):
                continue
            heard = _heard(topic)
            for uri in heard:
                self._tries.pop((topic, uri), None)
            if len(heard) < len(publishers):
                unheard |= {(topic, uri) for uri in map(self._master.uri_of, publishers) if uri not in heard}
        return frozenset(link for link in unheard if self._tries[link] < _MOST_TRIES)

    def _connect(self, links: FrozenSet[Link]) -> None:
        """Tell rospy of publishers as the master does."""
        self._tries.update(links)
        node = xmlrpc.client.ServerProxy(rospy.get_node_uri(), transport=TimedTransport(_ANSWER_TIMEOUT_S))
        for topic in {topic for topic, _ in links}:
            uris = [uri for of_topic, uri in links if of_topic == topic]
            rospy.loginfo("rospy missed the publisher of %s at %s; connecting", topic, ", ".join(uris))
            node.publisherUpdate(rospy.get_name(), topic, uris)


def _links() -> FrozenSet[Link]:
    """Return whom this node hears now."""
    topics = [subscriber.resolved_name for subscriber in list(get_topic_manager().subs.values())]
    return frozenset((topic, uri) for topic in topics for uri in _heard(topic))


def _heard(topic: str) -> FrozenSet[str]:
    """Return the XML-RPC addresses of the nodes that this one hears on a topic."""
    subscriber = get_topic_manager().get_subscriber_impl(topic)
    links = [] if subscriber is None else list(subscriber.connections)
    return frozenset(str(link.endpoint_id) for link in links if is_agreed(link))
