import pytest

from word_classes import turned_round


@pytest.mark.parametrize(
    "said, is_clause, turned",
    [
        ("Bring me my mug.", False, "Bring you your mug"),
        ("bring your mug", False, "bring my mug"),
        ("you see a wall", True, "I see a wall"),
        ("you are lost", True, "I am lost"),
        ("I am at home", True, "you are at home"),
        ("my phone rings", True, "your phone rings"),
    ],
)
def test_words_from_the_view_of_the_robot(said: str, is_clause: bool, turned: str) -> None:
    assert turned_round(said, is_clause=is_clause) == turned
