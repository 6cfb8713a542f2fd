"""Pictures that are saved."""

import os
import resource

import pytest
from stepwire.show import Picture


def test_a_picture_is_saved_whole_or_not_at_all(tmp_path):
    picture, path = Picture("a picture", lambda: "<svg>" + 100_000 * " " + "</svg>"), tmp_path / "a.svg"
    path.write_text("former")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    for size in (1, 1000, 100_000):
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
        try:
            with pytest.raises(OSError, match="File too large"):
                picture.save(path)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)
        assert path.read_text() == "former" and os.listdir(tmp_path) == ["a.svg"]
    picture.save(path)
    assert path.read_text() == picture.svg
