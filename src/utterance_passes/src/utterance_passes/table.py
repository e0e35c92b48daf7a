"""Lists every pass from the text to the tree that the framer reads, in the order of running. No pass calls another.

``text_table`` has the passes on text; ``clause_table`` and ``attaching_table`` have those
that correct the parse.
"""

from typing import Tuple

from utterance_passes import (
    argument_clusters,
    aspectual_verbs,
    command_verb,
    comparisons,
    corrections,
    formulas,
    light_verbs,
    mentioned_words,
    objections,
    quotations,
    reasons,
    run_ons,
    shared_verbs,
    surroundings,
    times,
)
from utterance_passes.attaching_table import ATTACHING_PASSES
from utterance_passes.clause_table import CLAUSE_PASSES
from utterance_passes.joined_table import JOINING_PASSES
from utterance_passes.text_table import TEXT_PASSES, WORD_PASSES
from utterance_passes.utterance_pass import (
    CutPass,
    Example,
    Pass,
    Stage,
    SurroundingsPass,
    TreeDisfluency,
    TreeMeaning,
    TreePass,
    TreePolicy,
    TreeRepair,
)
from utterance_passes.vocabulary import Speech, Verbs

_TURN = Verbs(frozenset(["turn", "go"]), lists={"turn": (("left", "right"),)})


#: Find words that the parser leaves out, and adds to the tree of the command later.
SURROUNDINGS_PASSES: Tuple[SurroundingsPass, ...] = (
    SurroundingsPass(
        "surroundings",
        'Parse a command without the words around it: "could you ..., please".',
        Example(
            "robot, could you turn left please",
            ("turn left", "robot: vocative", ",: punct", "could: aux", "you: nsubj", "please: discourse:aside"),
            _TURN,
        ),
        Stage.PARSER,
        surroundings.surroundings,
    ),
)

#: Find the places where the parser cuts a text, to parse each part alone.
CUT_PASSES: Tuple[CutPass, ...] = (
    CutPass(
        "run_ons",
        "Separate commands that have no mark between them.",
        Example("open|VERB the|DET box|NOUN close|ADP the|DET door|NOUN", ("4",), Verbs(frozenset(["open", "close"]))),
        Stage.PARSER,
        run_ons.run_ons,
    ),
)

#: Passes that the parser runs on its own tree before it publishes the tree.
PARSER_TREE_PASSES: Tuple[TreePass, ...] = (
    TreeRepair(
        "reroot",
        "Make the verb of the command the root.",
        Example(
            "Scrub|VERB|3|compound the|DET|3|det pot|NOUN|0|root",
            ("Scrub: compound(pot) -> root", "pot: root -> obj(Scrub)"),
            Verbs(frozenset(["scrub"])),
        ),
        Stage.PARSER,
        command_verb.rerooted,
    ),
)

#: Remove the words that a person takes back; they run before all other passes of the framer.
CORRECTION_PASSES: Tuple[TreePass, ...] = (
    TreeMeaning(
        "mentioned_words",
        "Make a noun phrase of a clause between quotation marks that is spoken of.",
        Example(
            'forget|VERB|0|root "|PUNCT|3|punct open|VERB|1|ccomp it|PRON|3|obj "|PUNCT|3|punct',
            ("open: ccomp(forget) VERB/open -> obj(forget) NOUN/open", "it: obj(open) -> flat:quoted(open)"),
        ),
        Stage.FRAMER,
        mentioned_words.with_mentioned_words,
    ),
    TreePolicy(
        "objection",
        "Set aside the opening of a correction if a whole command follows.",
        Example(
            "no|INTJ|3|discourse ,|PUNCT|1|punct turn|VERB|0|root left|ADV|3|advmod",
            ("no: discourse(turn) -> discourse:aside(turn)", ",: punct(no) -> discourse:aside(turn)"),
            _TURN,
        ),
        Stage.FRAMER,
        objections.without_objection,
    ),
    TreeDisfluency(
        "restarts",
        "Drop the first of two equal words in a row.",
        Example(
            "turn|VERB|0|root turn|VERB|1|xcomp left|ADV|2|advmod",
            ("turn: root -> reparandum(turn-2)", "turn: xcomp(turn-1) -> root"),
        ),
        Stage.FRAMER,
        corrections.without_restarts,
    ),
    TreeDisfluency(
        "corrections",
        "Replace the corrected words by the correction; ask if it is not certain which words those are.",
        Example(
            "turn|VERB|0|root left|ADV|1|advmod|left|RB no|DET|4|det right|NOUN|1|obj|right|NN",
            (
                "left: advmod(turn) -> reparandum(right)",
                "no: det(right) -> reparandum(right)",
                "right: obj(turn) NOUN/right -> advmod(turn) ADV/right",
            ),
            _TURN,
        ),
        Stage.FRAMER,
        corrections.without_corrected,
    ),
)

#: Correct the parse; they run on trees that other programs learn from, too.
PARSE_CORRECTING_PASSES: Tuple[TreePass, ...] = CLAUSE_PASSES + ATTACHING_PASSES

#: Correct the parse, replace or set aside phrases of the speaker, and mark clauses and times.
REPHRASING_PASSES: Tuple[TreePass, ...] = (
    JOINING_PASSES
    + PARSE_CORRECTING_PASSES
    + (
        TreeMeaning(
            "aspectual_verbs",
            'Replace "start moving", "continue to move" and the like by "move".',
            Example(
                "start|VERB|0|root turning|VERB|1|xcomp|turn|VBG",
                ("start: root -> discourse:aside(turning)", "turning: xcomp(start) -> root"),
                _TURN,
            ),
            Stage.FRAMER,
            aspectual_verbs.without_aspectual_verbs,
        ),
        TreeMeaning(
            "light_verbs",
            'Replace light verbs by the verbs that they mean, if the lexicon has those: "can I have" means "I want".',
            Example(
                "can|AUX|3|aux I|PRON|3|nsubj have|VERB|0|root tea|NOUN|3|obj",
                ("have: VERB/have have -> VERB/want want",),
                Verbs(frozenset(["want"])),
            ),
            Stage.FRAMER,
            light_verbs.replace_light_verbs,
        ),
        TreeMeaning(
            "quotations",
            "Turn the words that the robot shall say into one object.",
            Example(
                "tell|VERB|0|root her|PRON|3|nmod:poss|her|PRP$ lunch|NOUN|5|nsubj is|AUX|5|cop|be ready|ADJ|1|ccomp",
                (
                    "her: nmod:poss(lunch) -> iobj(tell)",
                    "lunch: nsubj(ready) -> flat:quoted(ready)",
                    "is: cop(ready) -> flat:quoted(ready)",
                    "ready: ccomp(tell) -> obj(tell)",
                ),
                Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
            ),
            Stage.FRAMER,
            quotations.with_quotations,
        ),
        TreeMeaning(
            "comparisons",
            'Set aside comparisons such as "as soon as possible".',
            Example(
                "go|VERB|0|root as|ADV|3|advmod fast|ADV|1|advmod as|ADV|5|advmod possible|ADJ|1|xcomp to|ADP|7|case "
                "Bob|PROPN|5|obl",
                (
                    "as: advmod(fast) -> discourse:aside(go)",
                    "fast: advmod(go) -> discourse:aside(go)",
                    "as: advmod(possible) -> discourse:aside(go)",
                    "possible: xcomp(go) -> discourse:aside(go)",
                    "Bob: obl(possible) -> obl(go)",
                ),
            ),
            Stage.FRAMER,
            comparisons.without_comparisons,
        ),
        TreeMeaning(
            "formulas",
            'Set aside the formulas around a command: "... if you don\'t mind".',
            Example(
                "turn|VERB|0|root right|ADV|3|advmod away|ADV|1|advmod",
                ("right: advmod(away) -> discourse:aside(turn)", "away: advmod(turn) -> discourse:aside(turn)"),
                Verbs(frozenset(["turn"])),
            ),
            Stage.FRAMER,
            formulas.without_formulas,
        ),
        TreeMeaning(
            "reasons",
            "Set aside a clause that says why to do something.",
            Example(
                "come|VERB|0|root because|SCONJ|5|mark I|PRON|5|nsubj am|AUX|5|cop cold|ADJ|1|advcl",
                (
                    "because: mark(cold) -> discourse:aside(come)",
                    "I: nsubj(cold) -> discourse:aside(come)",
                    "am: cop(cold) -> discourse:aside(come)",
                    "cold: advcl(come) -> discourse:aside(come)",
                ),
            ),
            Stage.FRAMER,
            reasons.without_reasons,
        ),
        TreeMeaning(
            "argument_clusters",
            "Turn each group of phrases that share a verb into a clause.",
            Example(
                "put|VERB|0|root mugs|NOUN|1|obj on|ADP|4|case tables|NOUN|1|obl and|CCONJ|6|cc plates|NOUN|4|conj "
                "in|ADP|8|case sinks|NOUN|1|obl",
                (
                    "plates: conj(tables) -> obj(put)",
                    "mugs on tables: a clause of its own",
                    "and plates in sinks: a clause of its own",
                ),
                Verbs(frozenset(["put"])),
            ),
            Stage.FRAMER,
            argument_clusters.expand_argument_clusters,
        ),
        TreeMeaning(
            "shared_verbs",
            "Attach the second of two phrases that share a verb to the verb, like the first.",
            Example(
                "go|VERB|0|root to|ADP|3|case Bob|PROPN|1|obl and|CCONJ|6|cc to|ADP|6|case Eve|PROPN|1|conj",
                ("Eve: conj(go) -> obl(go)",),
            ),
            Stage.FRAMER,
            shared_verbs.expand_shared_verbs,
        ),
        TreeMeaning(
            "times",
            "Mark the phrases that say when to do something.",
            Example("turn|VERB|0|root at|ADP|3|case five|NUM|1|obl", ("at five: says when",), _TURN),
            Stage.FRAMER,
            times.with_times,
        ),
    )
)

FRAMER_TREE_PASSES: Tuple[TreePass, ...] = CORRECTION_PASSES + REPHRASING_PASSES
#: All passes in order, from the text to the tree that the framer reads.
PASSES: Tuple[Pass, ...] = (
    TEXT_PASSES + WORD_PASSES + SURROUNDINGS_PASSES + CUT_PASSES + PARSER_TREE_PASSES + FRAMER_TREE_PASSES
)
