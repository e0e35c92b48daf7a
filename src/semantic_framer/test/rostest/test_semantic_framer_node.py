#!/usr/bin/python3
"""The node: parses by hand in, lexical units or one final event out for each command."""

import os
import tempfile
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import (
    Command,
    CommandLexicalUnits,
    CommandParse,
    FileProblems,
    FilledLexicalUnitList,
    FrameCatalogue,
    KnownName,
    KnownNames,
    Lexicon,
    Reply,
    SourceFile,
    StageEvent,
    StopReport,
)
from roboframenet_msgs.srv import AddLexicalUnit
from stanford_parser_msgs.msg import UniversalWord

from roboframenet_testing import wait_until

CARRYING = (
    "name: carrying\nframe_elements:\n  - {name: theme, is_core: True, semantic_type: Physical_object}\n"
    "  - {name: agent, semantic_type: Sentient}\n"
)
CARRY = "frame_name: carrying\nverb: carry\nframe_element_grammatical_relations:\n  - {name: theme, relation: dobj}\n"
FRAME = "name: turning\nframe_elements:\n  - {name: direction, is_core: True, values: [left, right]}\n"
UNIT = (
    "- frame_name: turning\n  verb: turn\n  frame_element_grammatical_relations:\n"
    "    - {name: direction, relation: advmod, words: [left, right]}\n"
    "- frame_name: unheard_of\n  verb: vanish\n"
)
#: Of a command that says no time.
NO_STAMP = rospy.Time()


class SemanticFramerNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_semantic_framer_node")
        cls.folder = tempfile.TemporaryDirectory()
        cls.units, cls.units_2012, cls.events, cls.lexicons, cls.problems = [], [], [], [], []
        cls.subscribers = [
            rospy.Subscriber("command_lexical_units", CommandLexicalUnits, cls.units.append),
            rospy.Subscriber("filled_lexical_units", FilledLexicalUnitList, cls.units_2012.append),
            rospy.Subscriber("stage_events", StageEvent, cls.events.append),
            rospy.Subscriber("lexicon", Lexicon, cls.lexicons.append),
            rospy.Subscriber("file_problems", FileProblems, cls.problems.append),
        ]
        cls.parses = rospy.Publisher("command_parse", CommandParse, queue_size=10)
        cls.stops = rospy.Publisher("stop_report", StopReport, queue_size=10)
        cls.catalogue = rospy.Publisher("frame_catalogue", FrameCatalogue, queue_size=1, latch=True)
        rospy.wait_for_service("add_lexical_unit", timeout=60.0)
        cls.add = rospy.ServiceProxy("add_lexical_unit", AddLexicalUnit)
        connected = [cls.parses, cls.stops, cls.catalogue] + cls.subscribers
        wait_until(lambda: all(end.get_num_connections() for end in connected))
        assert cls.add(absolute_file_path=cls.file("units.yaml", UNIT)).success
        assert cls.add(absolute_file_path=cls.file("carry.yaml", CARRY)).success
        files = [SourceFile(path="turning.yaml", text=FRAME), SourceFile(path="carrying.yaml", text=CARRYING)]
        cls.catalogue.publish(FrameCatalogue(registrar_id="test", files=files))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def file(cls, name, text):
        path = os.path.join(cls.folder.name, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path

    def say(self, command_id, *rows, stamp=NO_STAMP):
        """Publish a parse; each row is form, lemma, part of speech, tag, head, relation."""
        words = []
        for index, row in enumerate(rows, start=1):
            form, lemma, upos, xpos, head, deprel = row.split()
            words.append(
                UniversalWord(index=index, form=form, lemma=lemma, upos=upos, xpos=xpos, head=int(head), deprel=deprel)
            )
        text = " ".join(word.form for word in words)
        self.parses.publish(CommandParse(command=Command(id=command_id, stamp=stamp, text=text), words=words))

    def events_of(self, command_id):
        return [event for event in list(self.events) if event.command.id == command_id]

    def ending(self, command_id):
        wait_until(lambda: self.events_of(command_id))
        (event,) = self.events_of(command_id)
        self.assertTrue(event.is_final)
        self.assertEqual([], [message for message in self.units if message.command.id == command_id])
        return event.reply

    def test_command_is_passed_on_with_its_frame(self):
        self.say("turn", "turn turn VERB VB 0 root", "left left ADV RB 1 advmod")
        wait_until(lambda: any(message.command.id == "turn" for message in self.units))
        wait_until(lambda: self.units_2012 and self.events_of("turn"))
        (message,) = [message for message in self.units if message.command.id == "turn"]
        unit = message.clauses[0].readings[0].lexical_unit
        self.assertEqual(("turning", "turn"), (unit.frame_name, unit.verb))
        self.assertEqual([("direction", "left")], [(e.name, e.argument) for e in unit.frame_elements])
        self.assertEqual([unit], self.units_2012[0].lexical_units)
        event = self.events_of("turn")[0]
        self.assertFalse(event.is_final)
        rules = [line.partition(":")[0] for line in event.trace.splitlines()]
        self.assertEqual(["utterance_kind", "clause", "unit", "rank", "outcome"], rules)

    def test_refusal_has_a_trace(self):
        self.say("refused", "never never ADV RB 2 advmod", "turn turn VERB VB 0 root")
        self.ending("refused")
        self.assertIn("negated: turn: refused.", self.events_of("refused")[0].trace)

    def test_trace_can_be_switched_off(self):
        events = []
        subscriber = rospy.Subscriber("quiet/stage_events", StageEvent, events.append)
        parses = rospy.Publisher("quiet/command_parse", CommandParse, queue_size=1)
        wait_until(lambda: subscriber.get_num_connections() and parses.get_num_connections())
        parses.publish(CommandParse(command=Command(id="quiet", text="")))
        wait_until(lambda: events)
        self.assertEqual(("NO_VERB", ""), (events[0].reply.code, events[0].trace))

    def test_negated_command_is_refused(self):
        self.say("not", "never never ADV RB 2 advmod", "turn turn VERB VB 0 root", "left left ADV RB 2 advmod")
        reply = self.ending("not")
        self.assertEqual((Reply.REFUSED, "NEGATED"), (reply.outcome, reply.code))

    def test_frame_that_no_file_describes(self):
        self.say("vanish", "vanish vanish VERB VB 0 root")
        self.assertEqual("UNKNOWN_FRAME", self.ending("vanish").code)

    def test_question_and_its_answer(self):
        self.say("ask", "turn turn VERB VB 0 root")
        reply = self.ending("ask")
        self.assertEqual((Reply.NEEDS_INFORMATION, "MISSING_ELEMENT"), (reply.outcome, reply.code))
        self.say("answer", "right right ADV RB 0 root")
        wait_until(lambda: any(message.command.id == "answer" for message in self.units))

    def test_names_that_a_program_sends_have_types(self):
        known = rospy.Publisher("known_names", KnownNames, queue_size=1, latch=True)
        known.publish(KnownNames(names=[KnownName(name="frobnicator", semantic_types=["Human"])]))
        outcomes = []
        # The names and the parses come on connections of their own.
        wait_until(lambda: self.outcome_of_carrying(outcomes) == "CONFIRM")
        # Names with a mistake are refused, and the names before stay.
        known.publish(KnownNames(names=[KnownName(name="frobnicator", semantic_types=["Humam"])]))
        self.assertEqual("CONFIRM", self.outcome_of_carrying(outcomes))
        known.publish(KnownNames(names=[KnownName(name="frobnicator", semantic_types=["Device"])]))
        wait_until(lambda: self.outcome_of_carrying(outcomes) == "")
        reading = (
            [message for message in self.units if message.command.id.startswith("carry")][-1].clauses[0].readings[0]
        )
        self.assertEqual(
            ["Device"], [phrase.semantic_type for argument in reading.arguments for phrase in argument.phrases]
        )

    def outcome_of_carrying(self, outcomes):
        """Say "carry the frobnicator"; return the code of the reply, which is empty if the command is passed on."""
        command_id = f"carry{len(outcomes)}"
        self.say(
            command_id, "carry carry VERB VB 0 root", "the the DET DT 3 det", "frobnicator frobnicator NOUN NN 1 obj"
        )
        wait_until(lambda: self.events_of(command_id))
        event = self.events_of(command_id)[0]
        outcomes.append(event.reply.code if event.is_final else "")
        if not event.is_final:
            wait_until(lambda: any(message.command.id == command_id for message in self.units))
        return outcomes[-1]

    def test_mistakes_in_the_file_of_names_are_published(self):
        problems = []
        subscriber = rospy.Subscriber("quiet/file_problems", FileProblems, problems.append)
        wait_until(lambda: problems)
        subscriber.unregister()
        (problem,) = problems[0].problems
        self.assertEqual(("UNKNOWN_TYPE", 2, "names.Anna"), (problem.code, problem.line, problem.key))
        self.assertIn("Human", problem.hint)

    def test_question_from_before_a_stop_is_answered_by_nothing(self):
        before = rospy.Time.now()
        self.stops.publish(StopReport(stop_stamp=before + rospy.Duration(1e-6)))
        answers = []
        # The report and the parses come on connections of their own.
        wait_until(lambda: self.is_refused_as_answer(answers, before))

    def is_refused_as_answer(self, answers, stamp):
        """Ask a question that was said at a time, and answer it; whether nothing comes of the answer."""
        number = len(answers)
        self.say(f"asked{number}", "turn turn VERB VB 0 root", stamp=stamp)
        self.say(f"answer{number}", "right right ADV RB 0 root")
        wait_until(lambda: self.events_of(f"answer{number}"))
        answers.append(self.events_of(f"answer{number}")[0])
        return answers[-1].is_final and answers[-1].reply.code == "TALK"

    def test_command_from_before_a_stop_is_not_understood_any_more(self):
        now = rospy.Time.now()
        self.stops.publish(StopReport(stop_stamp=now))
        said = []
        # The report and the parses come on connections of their own.
        wait_until(lambda: self.is_stopped(said, now))
        self.assertEqual([], [line for event in self.events_of(said[-1]) for line in event.trace.splitlines()])
        after = rospy.Time.now()
        self.say("after the stop", "turn turn VERB VB 0 root", "left left ADV RB 1 advmod", stamp=after)
        wait_until(lambda: any(message.command.id == "after the stop" for message in self.units))

    def is_stopped(self, said, stamp):
        """Say a command with this stamp; whether it ends as stopped."""
        said.append(f"before the stop {len(said)}")
        self.say(said[-1], "turn turn VERB VB 0 root", "left left ADV RB 1 advmod", stamp=stamp)
        wait_until(lambda: self.events_of(said[-1]))
        reply = self.events_of(said[-1])[0].reply
        return (reply.outcome, reply.code) == (Reply.SUPERSEDED, "STOPPED")

    def test_correction_is_marked(self):
        self.say("correction", "not not PART RB 2 advmod", "there there ADV RB 0 root")
        reply = self.ending("correction")
        self.assertEqual((Reply.REFUSED, "CORRECTION"), (reply.outcome, reply.code))

    def test_command_without_words_is_answered(self):
        self.say("empty")
        self.assertEqual("NO_VERB", self.ending("empty").code)

    def test_parse_whose_words_do_not_hang_together_is_answered(self):
        self.say("broken", "turn turn VERB VB 7 root")
        self.assertNotEqual(Reply.DONE, self.ending("broken").outcome)

    def test_lexicon_is_latched(self):
        wait_until(lambda: any("units.yaml" in f.path for m in self.lexicons for f in m.files))
        self.assertTrue(all(message.framer_id for message in self.lexicons))

    def test_wrong_file_is_refused_with_its_line_and_the_rest_works(self):
        path = self.file("wrong.yaml", "frame_name: turning\nverbs: turn\n")
        self.assertFalse(self.add(absolute_file_path=path).success)
        wait_until(lambda: any(p.path == path for m in self.problems for p in m.problems))
        problem = next(p for message in self.problems for p in message.problems if p.path == path and p.key == "verbs")
        self.assertEqual(2, problem.line)
        self.say("still", "turn turn VERB VB 0 root", "left left ADV RB 1 advmod")
        wait_until(lambda: any(message.command.id == "still" for message in self.units))

    def test_file_that_was_added_is_kept_for_a_restart(self):
        self.assertIn(
            os.path.join(self.folder.name, "units.yaml"), rospy.get_param("semantic_framer/_added_lexical_units")
        )


if __name__ == "__main__":
    rostest.rosrun("semantic_framer", "semantic_framer_node", SemanticFramerNodeTest)
