"""What is said about libraries that cannot be imported."""

import pytest

from jauspy.errors import ConfigError
from jauspy.platform.modular import check_libraries


def test_library_that_is_not_installed() -> None:
    with pytest.raises(ConfigError, match=r"^the arm needs no_such_library: pip install 'jauspy\[cell\]'$"):
        check_libraries("the arm", "json", "no_such_library")


@pytest.mark.parametrize(
    ("missing", "hint"), [("libgomp.so.1", "; on Debian and Ubuntu: apt-get install libgomp1"), ("libother.so.2", "")]
)
def test_library_that_misses_one_of_the_system(tmp_path, monkeypatch, missing: str, hint: str) -> None:
    name = f"needs_{missing.partition('.')[0]}"
    (tmp_path / f"{name}.py").write_text(f"raise ImportError('{missing}: cannot open shared object file')")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ConfigError) as raised:
        check_libraries("the arm", name)
    assert str(raised.value) == f"the arm cannot load {name}: {missing}: cannot open shared object file{hint}"
