"""What every test has: one context for the session, a look at its error state after each test, no skips in CI."""

import os
from itertools import count

import pytest

from app.gpu.context import context, of_thread


@pytest.fixture
def ctx():
    """The process's own OpenGL context without a window: one for the session, but for what a test window closed."""
    return context()


@pytest.fixture(scope="module")
def browser():
    """Chromium for the pages of a file of tests; loaded by those alone."""
    from tests.browser import CHROMIUM, chromium

    assert CHROMIUM, "CI must have Chromium"
    with chromium() as found:
        yield found


@pytest.fixture(scope="session")
def progress_folders(tmp_path_factory):
    return tmp_path_factory.mktemp("progress"), count()


@pytest.fixture(autouse=True)
def own_progress(monkeypatch, progress_folders):
    """Each test begins without a past, and leaves the person's own alone."""
    folder, numbers = progress_folders
    monkeypatch.setenv("HALFWAY_DATA", str(folder / str(next(numbers))))


@pytest.fixture(autouse=True)
def no_gl_error():
    """A test that left an OpenGL error behind fails, and not the one after it."""
    yield
    if of_thread.cache_info().currsize:
        with context() as now:
            error = (now or context()).error
        assert error == "GL_NO_ERROR"


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """In CI a skipped test is a failed one: a missing library or driver must not pass unseen."""
    outcome = yield
    report = outcome.get_result()
    if report.skipped and not hasattr(report, "wasxfail") and os.environ.get("CI") == "true":
        report.outcome = "failed"
        report.longrepr = f"skipped in CI: {report.longrepr}"
