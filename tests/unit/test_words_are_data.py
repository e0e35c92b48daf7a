"""English words that rules compare with a sentence are in ``words.yaml`` and ``formulas.yaml``, not in modules."""

import ast
import re
from pathlib import Path
from typing import Dict, FrozenSet, Iterator, List, Set, Tuple

import pytest
from word_lists import WordList, word_lists

from semantic_frames.relation_names import STANFORD, UNIVERSAL
from typed_arguments.attribute_names import QUANTIFIERS
from typed_arguments.attribute_names import RELATIONS as RELATIONS_OF_ARGUMENTS
from word_classes import word_classes

SOURCES = Path(__file__).resolve().parents[2] / "src"
RELATIONS = UNIVERSAL | STANFORD

#: Modules that hold words of speech on purpose.
EXEMPT = {
    "command_server/command_behind.py": "what stands behind a cry is found without reading a file",
    "command_server/spoken_words.py": "the robot stops without reading a file",
    "command_server/cries.py": "the robot stops without reading a file",
    "command_server/stop_words.py": "the robot stops without reading a file",
    "command_server/taking_back.py": "the robot stops without reading a file",
    "semantic_framer/clock_times.py": "the grammar of times: parts of the day stand behind three prepositions",
    "semantic_framer/objections.py": "patterns of corrections: not yet in formulas.yaml",
    "spoken_quantities/measure.py": "spoken numbers",
    "spoken_quantities/numbers.py": "spoken numbers",
    "utterance_passes/amounts.py": "spoken numbers",
    "utterance_passes/measures.py": "spoken numbers",
    "utterance_passes/spelling.py": "spoken numbers: units that are written to a number",
}
#: Exempt words: nobody says them to the robot, or each has its own treatment. Other lists of the module count.
NO_SPEECH: Dict[str, Tuple[str, str]] = {
    "arbitrator/node_runs.py": ("outcomes of SMACH", "succeeded, aborted, preempted"),
    "arbitrator/plan.py": ("names of fields", "condition, child, otherwise"),
    "arbitrator/plan_nodes.py": ("names of fields", "kind, label, children, candidates, after"),
    "arbitrator/ros_messages.py": ("names of fields", "kind, label, count, most, trigger"),
    "arbitrator/state_machine.py": ("labels of states", "together, monitor, next round"),
    "command_server/ros_open_commands.py": ("keys of a record", "id, text, order"),
    "executor/ros_driver_settings.py": ("keys of a record", "node, name, former"),
    "executor/driver_settings.py": ("keys of a record", "node, name, former"),
    "frame_learning/outcome_score.py": (
        "headings and keys of JSON",
        "acted on, stops, refused, errors, codes, talk, answered, lines",
    ),
    "frame_learning/corpus_mapping.py": ("keys of a file", "frames, descriptions, arguments"),
    "frame_bindings/binding_file.py": (
        "keys of a file",
        "frame, name, action, service, topic, type, fields",
    ),
    "condition_watchers/node.py": ("names of relations", "at, in, near"),
    "frame_bindings/condition_file.py": (
        "keys of a file",
        "frame, name, topic, type, entries, where, field, comparison, value, element, default, values, factor",
    ),
    "experience/experience_command.py": ("words of a command line", "list, explain, reset, export, import"),
    "experience/node.py": ("keys of a diagnostic", "trials, rules, lost"),
    "location_memorizer/locations.py": ("keys of a file", "x, y, heading"),
    "offline_pipeline/pipeline.py": (
        "keys of JSON",
        "text, tokens, frames, reply, outcome, code, sentence, name, argument, typed",
    ),
    "roboframenet_ros/ros_live_parameters.py": (
        "keys of dynamic_reconfigure",
        (
            "class, cstate, default, defaults, description, groups, id, level, lower, max, "
            "min, name, parameters, parent, srcfile, srcline, state, type, upper, value"
        ),
    ),
    "pr2_props/named_arms.py": ("names of quantifiers", "each, every, all, both"),
    "pr2_props/node.py": ("names of props", "hug, hugging, pound, pounding, wave, waving"),
    "question_answering/answers.py": (
        "words of the answers: days, nouns with an article",
        "today, tomorrow, yesterday, any, some, a",
    ),
    "referring_expressions/describing.py": (
        "words of the answers: nouns with an article, determiners in the view of the robot",
        "my, your, our, any, some, no, other, uni, use, eu, one, s, x, ch, sh, ss, us, is",
    ),
    "referring_expressions/fitting.py": ("values of WorldRelation", "of, to, in, on"),
    "referring_expressions/resolving.py": (
        "values of Phrase.quantifier",
        "a, any, some, another, several, many, few, most, all, every, each, both",
    ),
    "rfnserver/goal_binding.py": ("keys of a declaration", "element, unit, default, value, values"),
    "rfnserver/goal_types.py": ("types of ROS", "bool, string, duration"),
    "roboframenet_demo/node.py": ("headings", "sentence, domain, frame and elements, verdict"),
    "roboframenet_demo/script.py": ("keys of a file", "say, outcome, expect, tolerance, interrupt, person"),
    "roboframenet_ros/parameters.py": ("suffixes of names that say the unit", "s, hz, m, rad"),
    "roboframenet_sim/home_actions.py": (
        "actions and relations of the home",
        ("close, give, grasp, in, lock, on, open, put, receive, switch, under, unlock"),
    ),
    "roboframenet_sim/home_engine.py": (
        "actions of the home",
        ("face, give, go, grasp, put, receive, tow"),
    ),
    "roboframenet_sim/home_file.py": (
        "keys and traits of a file",
        (
            "answers, attachable, bakes, beside, button, category, cleans, closable, cloth, color, container, "
            "contents, cuts, dish, doors, dries, flat, food, from, furniture, habit, heading, heats, hot, in, "
            "irons, level, light, lockable, names, on, passage, persons, posture, rack, raisable, room, rooms, "
            "screen, seat, settable, setting, size, station, stirs, surface, sweeps, switch, thing, things, to, "
            "toy, traits, trash, under, vessel, washable, washes, water, x, y"
        ),
    ),
    "roboframenet_sim/home_floor.py": (
        "relations of the home",
        ("behind, in, under"),
    ),
    "roboframenet_sim/home_people.py": (
        "what persons of the home understand",
        ("come with me, follow, follow me, stand, stay, stop, wait, we are there"),
    ),
    "roboframenet_sim/home_rules.py": (
        "actions and treatments of the home",
        (
            "arm, attach, back, backward, bake, boil, chop, cut, detach, dock, dry, fold, fry, gesture, iron, "
            "lift, look, mix, nearer, peel, photograph, pour, press, push, raise, rinse, rotate, scrub, slice, "
            "sort, sweep, throw, treat, wait, wipe"
        ),
    ),
    "roboframenet_sim/home_state.py": (
        "relations of the home",
        ("behind, beside, held, in, on, under"),
    ),
    "roboframenet_sim/home_truth.py": (
        "names of the truth",
        ("robot.arm, robot.holds, robot.room"),
    ),
    "roboframenet_sim/home_looks.py": ("values of WorldObject", "clean, dirty, folded, full, off, on, wet"),
    "roboframenet_sim/ros_world_objects.py": ("kinds of the home file", "door, furniture, person, robot, room"),
    "home_servers/frames.py": (
        "names of frames; settings of devices: not yet in words.yaml",
        (
            "aliveness, answering, asking, attaching, awaiting, baking, boiling, bowing, brightening, bringing, "
            "cancelling, charging, cheffing, chopping, cleaning, closing, comparing, cooking, counting, dancing, "
            "decreasing, departing, describing, detaching, devices, dimming, discarding, docking, emptying, "
            "fetching, folding, following, frying, gesturing, giving, grasping, greeting, heat, identifying, "
            "increasing, inspecting, introducing, ironing, laundering, lifting, listing, loading, locating, locking, "
            "lowering, meeting, mixing, moving, music, navigation, nodding, observing, offering, opening, "
            "parting, patrolling, peeling, perceiving, photographing, placing, playing, pointing, pouring, "
            "pressing, props, pulling, pushing, raising, reminding, reporting, requesting, restarting, rinsing, "
            "rotating, saying, scouring, scrubbing, serving, slicing, sliding, socializing, speaking, stacking, "
            "sweeping, taking, telling, temperature, throwing, ungrasping, unlocking, verifying, volume, waving, wiping"
        ),
    ),
    "home_servers/going.py": (
        "what a robot in a home knows: not yet in words.yaml",
        ("batteries, battery, here, place, room, your"),
    ),
    "home_servers/handling.py": (
        "what a robot in a home knows: not yet in words.yaml",
        ("back, backward, counter, desk, down, forward, higher, left, lower, right, table, up"),
    ),
    "home_servers/housework.py": (
        "what a robot in a home knows: not yet in words.yaml",
        (
            "bake, boil, chop, cloth, clothes, cut, dish, dishes, dry, fry, iron, knife, laundry, mix, pan, peel, "
            "rinse, scrub, skillet, slice, sponge, spoon, sweep, washing, wipe, wok"
        ),
    ),
    "home_servers/conditions.py": (
        "quantifiers, and states of the home",
        "all, every, each, both, a, any, some, open, closed, on, off, dirty, clean",
    ),
    "home_servers/looking.py": (
        "what a robot in a home knows: not yet in words.yaml",
        ("a, all, an, clean, closed, dirty, each, empty, every, full, locked, off, on, open, shut, the, unlocked, wet"),
    ),
    "home_servers/memory.py": (
        "what a robot in a home knows: not yet in words.yaml",
        (
            "adjective, anybody, anyone, big, black, blue, brown, compound, everybody, everyone, green, guest, guests, "
            "item, items, object, objects, people, person, persons, red, small, somebody, someone, superlative, thing, "
            "things, visitor, visitors, white, yellow"
        ),
    ),
    "home_servers/ros_body.py": (
        "sorts of WorldObject",
        ("door, person, place"),
    ),
    "home_servers/skills.py": (
        "what a robot in a home knows: not yet in words.yaml",
        (
            "at, basket, behind, beside, box, cupboard, dishwasher, drawer, fridge, i, in, "
            "machine, me, myself, near, on, oven, robot, sink, sitting, standing, "
            "under, us, walking, wardrobe, we, you, yourself"
        ),
    ),
    "home_servers/talking.py": (
        "what a robot in a home knows: not yet in words.yaml",
        ("music, radio, song, the room, the view, this room"),
    ),
    "roboframenet_sim/room.py": ("keys of a file", "bounds, walls, boxes"),
    "roboframenet_tools/cli.py": (
        "commands of rfn",
        (
            "bind, check, completion, doctor, experience, explain, graph, learn, list, new, passes, port, record, "
            "replay, say, score, voice"
        ),
    ),
    "roboframenet_tools/listing.py": (
        "headings and kinds",
        "domain, domains, frames, grounded, grounded frames, lexical units, robots",
    ),
    "roboframenet_tools/binding_text.py": ("names of elements", "goal, place, location, destination"),
    "roboframenet_tools/recording.py": ("keys of a record", "sentence, outcome, code, reply, frames, text"),
    "roboframenet_tools/ros_action_types.py": ("examples in a new file", "ten seconds, two minutes, an hour"),
    "roboframenet_tools/scaffold.py": (
        "examples and places in a template",
        "the ball, the box, the red mug, sentence, package, capital, name, element, verb",
    ),
    "roboframenet_tools/verb_forms.py": (
        "letters at the end of a verb",
        "ch, ea, au, oo, ai, ou, r, us, ir, os, as, ut, in, at, iz, ag, ul, ar, id",
    ),
    "semantic_frames/problem.py": ("keys of a problem", "key, expected, hint, found, path"),
    "web_console/arcs.py": ("attributes of SVG", "class, height, rx, label-ground"),
    "web_console/arguments.py": (
        "kinds of measures",
        "length, angle, duration, speed, temperature, volume, mass",
    ),
    "web_console/health.py": (
        "stages, topics and what the page says about nodes",
        (
            "arbitrator, carries plans out, does not answer, executor, fills frames, is missing, lexicon, "
            "orders candidates, parses sentences, runs, stops the robot"
        ),
    ),
    "web_console/picture.py": (
        "elements and attributes of SVG",
        "circle, path, rect, text, class, d, x, y, r, rx, cx, cy, width, height, text-anchor",
    ),
    "web_console/progress.py": ("outcomes of SMACH", "succeeded, aborted, preempted"),
    "frame_learning/gpsr_commands.py": (
        "names of the generators' rules and slots",
        "ptask, polite, task, main, please, pmain, sub, pos, paj, posadj",
    ),
    "frame_learning/gpsr_grammar.py": (
        "names of the generators' slots",
        "beacon, female, aobject, kobject, sobject, male, room, placement",
    ),
    "frame_learning/gpsr_meaning.py": (
        "keys of a file",
        "kinds, between, types, macros, clauses, frames, said, asks, performer",
    ),
    "frame_learning/gpsr_world.py": (
        "names of the generators' slots",
        "category, name, gesture, object, place, whattosay, room",
    ),
    "frame_learning/score_command.py": (
        "keys of JSON and headings",
        ("commands, fp, em, coverage, annotated, predicted, right, precision, right heads, frame, taken for"),
    ),
    "phrase_meanings/head_words.py": ("kinds of a modifier", "adjective, comparative, superlative"),
    "phrase_meanings/meaning_file.py": (
        "keys of a file",
        "relations, directions, quantifiers, bounds, exceptions",
    ),
    "semantic_framer/fragments.py": ("kinds of fragments", "openings, endings, faster, slower, louder, quieter"),
    "semantic_framer/link_file.py": (
        "keys of a file",
        "links, joiners, deeds, orders, counts, bounds, words, kind, name, question",
    ),
    "semantic_framer/word_patterns.py": ("kinds of slots", "word, state, measure, destination, place"),
    "semantic_framer/mood_file.py": (
        "keys of a file",
        "spellings, parts, acting, telling, name, kind, pattern, example",
    ),
    "semantic_framer/questions.py": ("endings of contracted verbs", "'s, 're, 'm, 'd"),
    "semantic_framer/objections.py": (
        "keys of a file",
        "corrections, contrasts, forbidding, asking, reporting",
    ),
    "semantic_frames/extra_thematic.py": ("keys of a file", "name, prepositions, adverbs, heads, measure, clauses"),
    "semantic_frames/frame_file.py": (
        "keys of a file",
        (
            "name, description, children, framenet, confirm, default, quantity, minimum, maximum, values, relations, "
            "counts, quantifiers, question, answer"
        ),
    ),
    "semantic_frames/lexical_unit.py": ("kinds of slots", "word, state, measure, destination, place"),
    "semantic_frames/lexical_unit_file.py": (
        "keys of a file",
        "name, relation, argument, words, required, verb, question, remark, condition, values, examples",
    ),
    "semantic_frames/marked_yaml.py": ("values of YAML", "true, yes, false, no"),
    "semantic_frames/server_statement.py": (
        "keys of a statement",
        "purpose, heeds, unheeded, occupies, settings, robot, relations, values, most, node, name, value",
    ),
    "semantic_types/parts_of_speech.py": (
        "parts of speech; endings of forms",
        "verb, adv, noun, adj, ies, y, men, man, shes, sh, ches, ch, xes, x, zes, z, ses, s, es, e, ed, ing, er, est",
    ),
    "semantic_types/wordnet.py": (
        "endings of plurals",
        "ies, y, men, man, shes, sh, ches, ch, xes, x, zes, z, ses, s",
    ),
    "server_hosting/manifest.py": (
        "keys of a file",
        "frame, frames, server, launch, run, package, file, arguments, executable, name",
    ),
    "stanford_parser_ros/inference.py": ("keys of Stanza", "id, text, lemma, upos, xpos, feats"),
    "typed_arguments/parts.py": (
        "parts of an argument",
        (
            "text, words, head, lemma, relation, quantifier, count, direction, conjunction, possessor, complement, "
            "modifiers, referent, source, si, amount, unit, bound, change"
        ),
    ),
    "turtlebot_follower/node.py": ("names of elements", "goal, source, path, manner, area"),
    "turtlebot_follower/centroid.py": ("keys of numpy", "names, formats, offsets, itemsize"),
    "typed_arguments/attribute_names.py": (
        "names of relations and quantifiers, not the words that are said for them",
        ", ".join(name for name in RELATIONS_OF_ARGUMENTS | QUANTIFIERS if "_" not in name),
    ),
    "utter/speech.py": ("what the robot can tell, a sentence for each", "time, date, day, name"),
    "utterance_passes/places_told.py": ("pronouns, a subject for each object", "him, her, them, it"),
    "utterance_passes/formula_file.py": (
        "keys of a file",
        (
            "openings, anywhere, apart, comparisons, endings, objections, tails, withdrawals, fillers, contractions, "
            "pattern, example, becomes"
        ),
    ),
    "world_model/knowledge.py": ("values of WorldObject", "ajar, closed, lying, open, sitting, standing, walking"),
    "world_model/world.py": (
        "values of WorldRelation",
        (
            "above, around, at, below, beneath, beside, by, in, inside, into, near, on, onto, over, under, underneath, "
            "within"
        ),
    ),
    "world_model/world_file.py": (
        "keys of a file",
        (
            "places, doors, things, devices, persons, robots, name, names, category, attributes, states, size, x, y, "
            "z, heading, on, in, under, above, behind, beside, near, of, to"
        ),
    ),
    "world_model/world_object.py": ("fields of WorldObject", "attributes, states, relations"),
    "voice_recognition/ears.py": ("names of searches", "commands, answers, free"),
    "voice_recognition/voice_command.py": (
        "keys of JSON",
        "begin, end, verdict, offers, frame, elements, text, question",
    ),
    "word_classes/word_file.py": ("keys of a file", "for, includes, words"),
}


def modules() -> Iterator[Path]:
    yield from sorted(SOURCES.glob("*/src/**/*.py"))
    yield from sorted(path for path in SOURCES.glob("*/nodes/*") if path.is_file())


def name_of(path: Path) -> str:
    return str(path.relative_to(path.parents[1])) if path.parent.name != "nodes" else str(path.relative_to(SOURCES))


MODULES = {name_of(path): path for path in modules()}


def lists_of(name: str) -> List[WordList]:
    return word_lists(MODULES[name].read_text(encoding="utf-8"), RELATIONS)


def no_speech_of(name: str) -> FrozenSet[str]:
    return frozenset(NO_SPEECH.get(name, ("", ""))[1].split(", "))


@pytest.mark.parametrize("name", [name for name in MODULES if name not in EXEMPT])
def test_no_module_holds_a_list_of_english_words(name: str) -> None:
    assert not [one for one in lists_of(name) if not one.words <= no_speech_of(name)]


@pytest.mark.parametrize("name", sorted([*EXEMPT, *NO_SPEECH]))
def test_every_exception_is_needed(name: str) -> None:
    found = frozenset().union(*(one.words for one in lists_of(name)))
    assert found and (name in EXEMPT or found == no_speech_of(name))


@pytest.mark.parametrize(
    "code",
    [
        'WORDS = frozenset(["left", "right", "around"])',
        'WORDS = {"left", "right", "around"}',
        'WORDS = "left right around".split()',
        'WORDS = ("left", "right", "turn around")',
        'WORDS = (("turn", "left"), ("turn", "right"))',
        'ANGLES = {"left": 1.0, "right": -1.0, "around": 2.0}',
        'ANGLES = {("turn", "left"): 1.0, ("turn", "right"): -1.0}',
        'is_turn = word.form.lower() in ("left", "right", "around")',
        'is_turn = said == "left" or said == "right" or said == "around"',
        'is_none = said != "left" and said != "right" and said != "around"',
        'TURN = re.compile(r"^(left|right|around)\\b")',
        'TURN = re.compile("turn (to the )?(left|right|all the way)( now)?")',
        'TURN = re.compile(f"turn (left|right|around) {NOW}")',
        'MIXED = ["obj", "iobj", "left"]',
        "def turn(words=('left', 'right', 'around')):\n    return words",
    ],
)
def test_a_list_of_words_is_found(code: str) -> None:
    assert word_lists(code, RELATIONS)


@pytest.mark.parametrize(
    "code",
    [
        'OBJECTS = ("obj", "iobj", "obl")',
        'TAGS = ("NOUN", "PROPN", "PRON")',
        'NAMES = ("goal_x", "goal_y", "frame_id")',
        'SIDES = ("left", "right")',
        '"""It may say left|right|around."""',
        '__all__ = ["left", "right", "around"]',
        'EXAMPLE = "turn|VERB|0|root left|ADV|1|advmod|left|RB"',
        'WORDS = word_class("left_and_right")',
    ],
)
def test_other_code_is_not_taken_for_a_list_of_words(code: str) -> None:
    assert not word_lists(code, RELATIONS)


def asked_for() -> Dict[str, Set[str]]:
    """Return the names in calls for a word class, by module, and all strings of modules that import them."""
    found: Dict[str, Set[str]] = {}
    for name, path in MODULES.items():
        code = path.read_text(encoding="utf-8")
        if "from word_classes import" in code:
            found[name] = {
                node.value
                for node in ast.walk(ast.parse(code))
                if isinstance(node, ast.Constant) and isinstance(node.value, str)
            }
    return found


def test_every_requested_word_class_exists() -> None:
    unknown = {}
    for name in asked_for():
        for node in ast.walk(ast.parse(MODULES[name].read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("word_class", "word_list"):
                argument = node.args[0]
                if isinstance(argument, ast.Constant) and argument.value not in word_classes():
                    unknown[name] = argument.value
    assert not unknown


def test_every_word_class_is_used() -> None:
    text = (SOURCES / "word_classes/src/word_classes/words.yaml").read_text(encoding="utf-8")
    included = set(re.findall(r"\w+", " ".join(re.findall(r"includes: \[(.*)\]", text))))
    files = (
        "utterance_passes/src/utterance_passes/formulas.yaml",
        "semantic_framer/src/semantic_framer/fragments.yaml",
        "semantic_framer/src/semantic_framer/objections.yaml",
        "semantic_framer/src/semantic_framer/small_talk.yaml",
    )
    formulas = "".join((SOURCES / name).read_text(encoding="utf-8") for name in files)
    used = set().union(*asked_for().values()) | included | set(re.findall(r"<(\w+)>", formulas))
    own = {"determiners"}  # used by without_determiner
    assert not set(word_classes()) - used - own
