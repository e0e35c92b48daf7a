"""Lists the passes that correct nouns, counts and clauses of a parse, in the order of running; ``table`` has all."""

from typing import Tuple

from utterance_passes import (
    additions,
    wished_results,
)
from utterance_passes.utterance_pass import Example, Stage, TreeMeaning, TreePass
from utterance_passes.vocabulary import Verbs

#: Make nouns, counts and clauses of what the parser takes for something else.
CLAUSE_PASSES: Tuple[TreePass, ...] = (
    TreeMeaning(
        "not_only",
        'Set "not only" aside before "but".',
        Example(
            "take|VERB|0|root not|PART|1|advmod only|ADV|4|advmod cups|NOUN|1|obj but|CCONJ|6|cc plates|NOUN|4|conj",
            ("not: advmod(take) -> discourse:aside(take)", "only: advmod(cups) -> discourse:aside(take)"),
        ),
        Stage.FRAMER,
        additions.without_not_only,
    ),
    TreeMeaning(
        "wished_results",
        "Make a request for a deed of the wish for its result.",
        Example(
            "I|PRON|2|nsubj want|VERB|0|root the|DET|4|det door|NOUN|2|obj closed|VERB|4|acl|close|VBN",
            ("door: obj(want) -> obj(closed)", "closed: acl(door) -> xcomp(want)"),
            Verbs(frozenset(["close"])),
        ),
        Stage.FRAMER,
        wished_results.with_wished_results,
    ),
)
