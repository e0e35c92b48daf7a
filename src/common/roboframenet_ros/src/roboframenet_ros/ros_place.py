"""Where a stage runs: as a node of its own, or with others in one process."""

import threading
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Sequence

import rospy
from roboframenet_msgs.msg import FileProblem, FileProblems


class ProblemsTopic:
    """The topic ``file_problems`` of a process: latched, with the problems of all stages in it.

    rospy has one publisher of a topic in a process, and it latches one message; with a message for each stage, whoever
    comes late would hear of one stage only.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._problems: Dict[str, List[FileProblem]] = {}
        self._publisher: Optional[rospy.Publisher] = None

    def advertise(self) -> None:
        """Open the topic, if it is not open."""
        with self._lock:
            if self._publisher is None:
                self._publisher = rospy.Publisher("file_problems", FileProblems, queue_size=5, latch=True)

    def publish(self, stage: str, problems: Sequence[FileProblem]) -> None:
        """Publish the problems of all stages.

        Args:
            stage: whose problems are new
            problems: all of this stage
        """
        self.advertise()
        with self._lock:
            self._problems[stage] = list(problems)
            assert self._publisher is not None
            self._publisher.publish(FileProblems(problems=[one for each in self._problems.values() for one in each]))


@dataclass(frozen=True)
class Place:
    """What a stage needs to know of the process that it runs in.

    Attributes:
        private: prefix of its private names: "~" for a node of its own; with others in one process, "arbitrator/": the
            parameters keep their names
        problems: the topic ``file_problems`` of the process
    """

    private: str = "~"
    problems: ProblemsTopic = field(default_factory=ProblemsTopic)

    @property
    def namespace(self) -> str:
        """The namespace of its private names."""
        name = rospy.resolve_name("~" if self.private == "~" else self.private)
        return str(name).rstrip("/")
