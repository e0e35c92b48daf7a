"""Lists the passes that correct the tags of words, in the order of running; ``table`` has all passes."""

from typing import Tuple

from utterance_passes import nouns_taken_for_verbs, tagging
from utterance_passes.utterance_pass import Example, Stage, TagPass
from utterance_passes.vocabulary import Verbs

_TURN = Verbs(frozenset(["turn", "go"]), lists={"turn": (("left", "right"),)})

TAG_PASSES: Tuple[TagPass, ...] = (
    TagPass(
        "command_verb",
        "Tag the first word of a command as a verb if the lexicon knows it as one.",
        Example("Scrub|PROPN the|DET pot|NOUN", ("1 VERB VB",), Verbs(frozenset(["scrub"]))),
        Stage.PARSER,
        tagging.command_verb,
    ),
    TagPass(
        "verbs_behind_commas",
        "Tag a verb of the lexicon behind a comma as a verb that the tagger took for a noun.",
        Example(
            "find|VERB Anna|PROPN ,|PUNCT spot|NOUN Bob|PROPN",
            ("4 VERB VB",),
            Verbs(frozenset(["find", "spot"])),
        ),
        Stage.PARSER,
        tagging.verbs_behind_commas,
    ),
    TagPass(
        "verbs_behind_no",
        'Tag a verb of the lexicon behind "no" as a verb that the tagger took for a noun.',
        Example("turn|VERB left|ADV no|INTJ turn|NOUN right|ADV", ("4 VERB VB",), _TURN),
        Stage.PARSER,
        tagging.verbs_behind_no,
    ),
    TagPass(
        "verbs_behind_and",
        'Tag a verb of the lexicon between "and" and "to me" or a pronoun as a verb, not as a noun or an adjective.',
        Example(
            "count|VERB cups|NOUN and|CCONJ report|NOUN to|ADP me|PRON",
            ("4 VERB VB",),
            Verbs(frozenset(["count", "report"])),
        ),
        Stage.PARSER,
        tagging.verbs_behind_and,
    ),
    TagPass(
        "signs",
        "Tag signs before a number as adverbs.",
        Example("turn|VERB right|ADV minus|NOUN 4|NUM turns|NOUN", ("3 ADV RB",), _TURN),
        Stage.PARSER,
        tagging.signs,
    ),
    TagPass(
        "no_one",
        'Tag "no one" as a noun without anything.',
        Example("tell|VERB no|INTJ one|NUM lies|NOUN", ("2 DET DT", "3 NOUN NN"), Verbs(frozenset(["tell"]))),
        Stage.PARSER,
        tagging.no_one,
    ),
    TagPass(
        "sides_alone",
        "Tag a side without a subject as an adverb that the tagger took for a verb.",
        Example("left|VERB ,|PUNCT not|PART right|ADV", ("1 ADV RB",), _TURN),
        Stage.PARSER,
        tagging.sides_alone,
    ),
    TagPass(
        "nouns_in_lists",
        "Tag an item of a list as a noun that the tagger took for a verb.",
        Example(
            "bring|VERB knives|NOUN ,|PUNCT fork|VERB and|CCONJ spoon|VERB",
            ("4 NOUN NN", "6 NOUN NN"),
            Verbs(frozenset(["bring"])),
        ),
        Stage.PARSER,
        nouns_taken_for_verbs.nouns_in_lists,
    ),
    TagPass(
        "numbers_as_nouns",
        "Tag a number behind an article and an adjective as a noun.",
        Example("give|VERB me|PRON a|DET low|ADJ five|NUM", ("5 NOUN NN",), Verbs(frozenset(["give"]))),
        Stage.PARSER,
        tagging.numbers_as_nouns,
    ),
    TagPass(
        "amounts_as_verbs",
        'Tag the words of an amount as such that the tagger took for verbs: "and half a meter back".',
        Example("go|VERB on|ADV half|VERB a|DET meter|NOUN", ("3 DET PDT",), Verbs(frozenset(["go"]))),
        Stage.PARSER,
        nouns_taken_for_verbs.amounts_as_verbs,
    ),
    TagPass(
        "nouns_like_deeds",
        "Tag the second word of a noun of two words as a noun that the tagger took for a verb.",
        Example("go|VERB to|ADP the|DET night|NOUN stand|VERB", ("5 NOUN NN",), Verbs(frozenset(["go"]))),
        Stage.PARSER,
        nouns_taken_for_verbs.nouns_like_deeds,
    ),
    TagPass(
        "numbered_noun",
        'Tag a word between "to" and a final number or letter as a noun if the lexicon does not know it as a verb.',
        Example(
            "turn|VERB it|PRON to|PART level|VERB three|NUM", ("3 ADP IN", "4 NOUN NN"), Verbs(frozenset(["turn"]))
        ),
        Stage.PARSER,
        tagging.numbered_noun,
    ),
    TagPass(
        "adverbs",
        "Tag a word as an adverb that English knows neither as a noun nor as a verb.",
        Example("take|VERB the|DET mug|NOUN angrily|NOUN", ("4 ADV RB",), Verbs(frozenset(["take"]))),
        Stage.PARSER,
        tagging.adverbs,
    ),
    TagPass(
        "prepositions_as_verbs",
        "Tag a word before a noun as a preposition that the tagger took for a verb.",
        Example(
            "go|VERB to|ADP rooms|NOUN opposite|VERB the|DET lift|NOUN",
            ("4 ADP IN",),
            Verbs(frozenset(["go"])),
        ),
        Stage.PARSER,
        tagging.prepositions_as_verbs,
    ),
    TagPass(
        "left_behind",
        'Tag "left" between somebody and something as a verb that the tagger took for a side.',
        Example("Bob|PROPN left|ADV his|PRON keys|NOUN", ("2 VERB VBD",), Verbs()),
        Stage.PARSER,
        tagging.left_behind,
    ),
    TagPass(
        "prepositions_before_names",
        'Tag "to" before a name as a preposition that the tagger took for the mark of a verb.',
        Example("say|VERB hello|NOUN to|PART Bob|PROPN", ("3 ADP IN",), Verbs(frozenset(["say"]))),
        Stage.PARSER,
        tagging.prepositions_before_names,
    ),
    TagPass(
        "gerunds_as_nouns",
        "Tag a gerund between a verb and a noun as a noun if the verb takes no gerund.",
        Example("bring|VERB cleaning|VERB stuff|NOUN", ("2 NOUN NN",), Verbs(frozenset(["bring"]))),
        Stage.PARSER,
        tagging.gerunds_as_nouns,
    ),
    TagPass(
        "names_as_verbs",
        "Tag a word with a capital inside a sentence as a name that the tagger took for a verb.",
        Example("greet|VERB Bob|PROPN and|CCONJ Lisa|VERB", ("4 PROPN NNP",), Verbs(frozenset(["greet"]))),
        Stage.PARSER,
        tagging.names_as_verbs,
    ),
    TagPass(
        "small_names_as_verbs",
        "Tag a word in small letters that English does not know as a name where a person is named.",
        Example("give|VERB ravi|VERB the|DET keys|NOUN", ("2 PROPN NNP",), Verbs(frozenset(["give"]))),
        Stage.PARSER,
        tagging.small_names_as_verbs,
    ),
    TagPass(
        "nouns_behind_verbs",
        "Tag a word right behind the verb of the command as a noun that English does not know as a verb.",
        Example("give|VERB grandpa|VERB cups|NOUN", ("2 NOUN NN",), Verbs(frozenset(["give"]))),
        Stage.PARSER,
        tagging.nouns_behind_verbs,
    ),
    TagPass(
        "contracted_verbs",
        'Tag "\'s" as a verb where no noun follows that somebody could own.',
        Example("tell|VERB them|PRON dinner|NOUN 's|PART in|ADP halls|NOUN", ("4 AUX VBZ",), Verbs()),
        Stage.PARSER,
        tagging.contracted_verbs,
    ),
    TagPass(
        "verbs_of_conditions",
        "Tag a verb behind the subject of a condition that the tagger took for a noun.",
        Example("when|ADV Bob|PROPN leaves|NOUN the|DET office|NOUN", ("3 VERB VBZ",), Verbs()),
        Stage.PARSER,
        tagging.verbs_of_conditions,
    ),
    TagPass(
        "verbs_of_questions",
        'Tag a word behind "do" and a noun as a verb that the tagger took for a noun.',
        Example("who|PRON does|AUX Bob|PROPN belong|NOUN to|ADP", ("4 VERB VB",), Verbs()),
        Stage.PARSER,
        tagging.verbs_of_questions,
    ),
    TagPass(
        "resulting_states",
        "Tag a state behind a noun at the end as an adjective, not as a noun.",
        Example("push|VERB the|DET drawer|NOUN shut|NOUN", ("4 ADJ JJ",), Verbs(frozenset(["push"]))),
        Stage.PARSER,
        tagging.resulting_states,
    ),
    TagPass(
        "properties_of_pronouns",
        'Tag a property behind "anything" as an adjective that the tagger took for a noun.',
        Example("get|VERB anything|PRON sweet|NOUN", ("3 ADJ JJ",), Verbs(frozenset(["get"]))),
        Stage.PARSER,
        tagging.properties_of_pronouns,
    ),
)
