"""The files of frames: reads them into the graph, and tells their texts and their problems."""

import threading
from typing import Dict, List, Optional, Sequence, Tuple

import rospy
from roboframenet_msgs.msg import FrameCatalogue, SourceFile

from checked_files.source_files import FRAMES_FOLDER, read_text, replace_problems, yaml_files
from frame_registrar.graph import FrameGraph
from frame_registrar.ros_messages import to_file_problems
from roboframenet_ros.ros_place import Place
from semantic_frames import FileRefused, Problem, load_frame
from semantic_frames.frame import SemanticFrame

#: Written by the node, for its own restarts: files that were added while it ran.
#: Private parameter.
ADDED_FRAMES = "_added_frames"


class FrameFiles:
    """Keeps the frames of a graph as their files say.

    Publishes: frame_catalogue (FrameCatalogue, latched), and by its place file_problems (FileProblems, latched).
    """

    def __init__(self, graph: FrameGraph, lock: threading.Lock, place: Place, *, registrar_id: str) -> None:
        """
        Args:
            graph: gets the frames
            lock: who uses the graph has it
            place: of the node
            registrar_id: of the registrar, in what is published
        """
        self._graph, self._lock, self._place, self._id = graph, lock, place, registrar_id
        self._adding = threading.Lock()
        self._texts: Dict[str, str] = {}
        self._name_of_file: Dict[str, str] = {}
        self._problems: Tuple[Problem, ...] = ()
        self._learned: Dict[str, str] = {}
        self._catalogue = rospy.Publisher("frame_catalogue", FrameCatalogue, queue_size=1, latch=True)
        place.problems.advertise()

    @property
    def problems(self) -> Tuple[Problem, ...]:
        """What is wrong in files now."""
        return self._problems

    @property
    def paths(self) -> List[str]:
        """The files whose frames are in the graph; call it with the lock."""
        return list(self._texts)

    def load(self, folders: Sequence[str]) -> None:
        """Read the files of some folders, and those that were added before the node was started again."""
        added: List[str] = rospy.get_param(self._place.private + ADDED_FRAMES, [])
        for path in list(yaml_files(folders, FRAMES_FOLDER)) + added:
            self._add(path)

    def add(self, path: str) -> bool:
        """Add one file, and remember it for the next start; return whether its frame is in the graph now."""
        # This lock is separate: it keeps both of two files added at once, and no command waits for the master.
        with self._adding:
            is_added = self._add(path)
            if is_added:
                added = rospy.get_param(self._place.private + ADDED_FRAMES, [])
                if path not in added:
                    rospy.set_param(self._place.private + ADDED_FRAMES, added + [path])
                self.publish()
        return is_added

    def set_learned(self, files: Sequence[SourceFile]) -> bool:
        """Put the frames that persons have taught in the place of the earlier ones; return whether any has changed.

        Args:
            files: the text of each under the path by which it is known; no such files lie there
        """
        with self._adding:
            texts = {file.path: file.text for file in files}
            changed = [path for path, text in texts.items() if self._learned.get(path) != text]
            gone = [path for path in self._learned if path not in texts]
            for path in gone:
                self._remove(path)
            for path in changed:
                self._add(path, texts[path])
            self._learned = texts
            if changed or gone:
                self.publish()
            return bool(changed or gone)

    def _remove(self, path: str) -> None:
        with self._lock:
            frame = self._graph.frame(self._name_of_file.pop(path, ""))
            if frame is not None and frame.path == path:
                self._graph.remove(frame.name)
            self._texts.pop(path, None)
        self._tell_problems(path, ())

    def publish(self) -> None:
        """Tell the texts of all files."""
        # Under the lock: the later of two changes must stay latched.
        with self._lock:
            files = [SourceFile(path=path, text=text) for path, text in self._texts.items()]
            self._catalogue.publish(FrameCatalogue(registrar_id=self._id, files=files))

    def _add(self, path: str, text: Optional[str] = None) -> bool:
        """Add one file, which is read if its text is not given; its problems are logged and published."""
        problems: Tuple[Problem, ...] = ()
        try:
            # Commands need the lock, so the file is read before.
            text = read_text(path) if text is None else text
            frame = load_frame(text, path)
            with self._lock:
                self._add_frame(frame)
                self._texts[path] = text
        except FileRefused as refused:
            problems = refused.problems
        self._tell_problems(path, problems)
        return not problems

    def _tell_problems(self, path: str, problems: Tuple[Problem, ...]) -> None:
        for problem in problems:
            rospy.logerr("refused: %s", problem)
        self._problems = replace_problems(self._problems, path, problems)
        self._place.problems.publish("frame_registrar", to_file_problems(self._problems))

    def _add_frame(self, frame: SemanticFrame) -> None:
        before = self._graph.frame(frame.name)
        self._graph.add(frame)
        if before is not None and before.path != frame.path:
            rospy.logwarn("frame '%s' of %s replaces that of %s", frame.name, frame.path, before.path)
            self._texts.pop(before.path, None)
        old = self._graph.frame(self._name_of_file.get(frame.path, ""))
        if old is not None and old.name != frame.name and old.path == frame.path:
            rospy.loginfo("frame '%s' is removed: %s now describes '%s'", old.name, frame.path, frame.name)
            self._graph.remove(old.name)
        self._name_of_file[frame.path] = frame.name
