"""The messages of REP 155 have the sums of hri_msgs, so that nodes of others are understood."""

import pytest
from hri_msgs.msg import IdsList, LiveSpeech


@pytest.mark.parametrize(
    "message, checksum",
    [(LiveSpeech, "d1d0f996ef223aa810d45b3a627e91cd"), (IdsList, "84a63f55b5676f78b625e8a8bb809fe5")],
)
def test_the_sums_are_those_of_hri_msgs(message, checksum: str) -> None:
    assert message._md5sum == checksum
