"""Which topics cancel the goals of the robot's action servers."""
from typing import AbstractSet, FrozenSet, Iterable, Mapping

FRAME_GOAL_TYPE = "roboframenet_msgs/FilledSemanticFrameActionGoal"


def cancel_topic(server: str) -> str:
    """The topic on which an action server hears cancels."""
    return f"{server.rstrip('/')}/cancel"


def find_servers(topic_types: Mapping[str, str], subscribed_topics: AbstractSet[str],
                 other_servers: Iterable[str]) -> FrozenSet[str]:
    """Find the action servers to cancel.

    Args:
        topic_types: type of each topic that the master knows; it forgets none, not even of nodes that are gone
        subscribed_topics: topics that somebody hears
        other_servers: names of action servers that count whatever the type of their goals

    Returns:
        names of the servers that hear cancels now and either take filled frames as goals or are among the others
    """
    candidates = {topic[:-len("/goal")] for topic, topic_type in topic_types.items()
                  if topic.endswith("/goal") and topic_type == FRAME_GOAL_TYPE}
    candidates.update(name.rstrip("/") for name in other_servers)
    return frozenset(name for name in candidates if name and cancel_topic(name) in subscribed_topics)
