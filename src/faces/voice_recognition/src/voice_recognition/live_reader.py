"""Reads texts by what the robot that runs knows: files, servers, names and things come by topic, and change."""

from dataclasses import replace
from typing import Optional, Tuple

from frame_registrar.graph import FrameGraph
from offline_pipeline.knowledge import Knowledge as Files
from offline_pipeline.knowledge import load_texts
from offline_pipeline.pipeline import Pipeline
from semantic_types import WordTypes, shipped_types
from stanford_parser_ros.model import Parser, shipped_parser
from voice_recognition.calling import Calls
from voice_recognition.command_reading import CommandReader, make_reader
from voice_recognition.live_language import File, Knowledge, known_names
from voice_recognition.offers import OfferFinder
from world_model import World


class ReaderMaker:
    """Makes readers; the parser is loaded once, and files that have not changed are not read again."""

    def __init__(self) -> None:
        self._parser: Optional[Parser] = None
        self._read: Tuple[Tuple[Tuple[File, ...], Tuple[File, ...]], Optional[Files]] = (((), ()), None)

    def make(self, knowledge: Knowledge, finder: OfferFinder, world: World, calls: Calls) -> CommandReader:
        """Make a reader.

        Args:
            knowledge: what the robot knows
            finder: of the templates of its language
            world: its things, persons and places
            calls: by which names it is called, or they are
        Raises:
            ModelError: the models of the parser cannot be loaded
            NoWordNet: the database of nouns is not installed
        """
        if self._parser is None:
            self._parser = shipped_parser()
        files = self._files(knowledge)
        graph = FrameGraph()
        for frame in files.frames.values():
            graph.add(frame)
        for frame_name, server, profile in knowledge.servers:
            graph.register(frame_name, server, profile)
        types = WordTypes(shipped_types().nouns, known_names(knowledge.names))
        pipeline = Pipeline(replace(files, graph=graph, types=types), self._parser)
        return make_reader(pipeline, finder, world, calls, are_several=bool(knowledge.robots))

    def _files(self, knowledge: Knowledge) -> Files:
        key = (knowledge.frame_files, knowledge.unit_files)
        if self._read[0] != key or self._read[1] is None:
            frames = [(path, lambda text=text: text) for path, text in knowledge.frame_files]
            units = [(path, lambda text=text: text) for path, text in knowledge.unit_files]
            self._read = (key, load_texts(frames, units))
        files = self._read[1]
        assert files is not None
        return files
