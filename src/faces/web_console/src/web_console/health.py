"""Which nodes should be there, and which are."""

from typing import Dict, FrozenSet, Iterable, List, Mapping, Tuple

from web_console.views import HealthView, NodeView

#: Each stage: the name of its package, a topic that only it publishes, and what it is for.
STAGES: Tuple[Tuple[str, str, str], ...] = (
    ("command_server", "command_text", "accepts commands and replies"),
    ("stop_server", "stop_report", "stops the robot"),
    ("stanford_parser_ros", "command_parse", "parses sentences"),
    ("semantic_framer", "lexicon", "fills frames"),
    ("frame_registrar", "frame_catalogue", "knows frames and servers"),
    ("arbitrator", "command_plan", "orders candidates"),
    ("executor", "executor/smach/container_status", "carries plans out"),
)
RUNS, SILENT, MISSING = "runs", "does not answer", "is missing"


def nodes_to_ask(publishers: Mapping[str, FrozenSet[str]], topics: Mapping[str, str]) -> Dict[str, Tuple[str, ...]]:
    """Return the nodes of each stage.

    Args:
        publishers: nodes by resolved topic
        topics: resolved topic by stage
    """
    return {stage: tuple(sorted(publishers.get(topics[stage], ()))) for stage, _, _ in STAGES}


def health_of(
    stages: Mapping[str, Tuple[str, ...]], answering: FrozenSet[str], servers: Iterable[Tuple[str, str, bool]]
) -> HealthView:
    """Return the state of all nodes.

    Args:
        stages: nodes of each stage
        answering: nodes that have answered
        servers: name, frames and whether it lives, of each action server
    """
    found: List[NodeView] = []
    for stage, _, role in STAGES:
        nodes = stages.get(stage, ())
        for node in nodes:
            found.append(NodeView(node.lstrip("/"), role, RUNS if node in answering else SILENT))
        if not nodes:
            found.append(NodeView(stage, role, MISSING))
    for name, frames, is_alive in servers:
        found.append(NodeView(name.lstrip("/"), f"carries out {frames}", RUNS if is_alive else SILENT))
    return HealthView(tuple(found))
