"""Links and paths in documents lead somewhere."""

from __future__ import annotations

import re
from fnmatch import fnmatch
from pathlib import Path

import pytest

FOLDERS = ("benchmarks", "docs", "grammar", "lagdsl", "models", "stdlib", "tests")


def documents(root: Path) -> list[Path]:
    """README and its neighbors, all pages of docs/, the indexes of models and benchmarks."""
    return [
        *root.glob("*.md"),
        *(root / "docs").rglob("*.md"),
        *root.glob("models/*.md"),
        *root.glob("benchmarks/*.md"),
    ]


def prose(page: Path) -> str:
    """The page without blocks of code, where brackets are arrays."""
    return re.sub(r"^ *(`{3,}).*?^ *\1`*$", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """The anchors of the headings, formed as GitHub and MyST do."""
    headings = re.findall(r"^#+ +(.*?)#*$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-") for heading in headings}


def written_by_the_build(root: Path) -> list[str]:
    """Patterns of the pages and folders of docs/ that `make docs` writes: git ignores them."""
    lines = (root / ".gitignore").read_text(encoding="utf-8").splitlines()
    return [line[1:] + "*" * line.endswith("/") for line in lines if line.startswith("/docs/")]


def test_links_between_documents_lead_somewhere(root: Path) -> None:
    broken = []
    later = written_by_the_build(root)
    for page in documents(root):
        for target, anchor in re.findall(
            r"\]\(([A-Za-z0-9_./-]*)(?:#([^)\s]*))?\)", re.sub(r"`[^`]*`", "", prose(page))
        ):
            found = (page.parent / target).resolve() if target else page
            inside = found.relative_to(root).as_posix() if found.is_relative_to(root) else ""
            if any(fnmatch(inside, pattern) for pattern in later) and not found.exists():
                continue
            if not found.exists() or (anchor and found.suffix == ".md" and anchor not in anchors(found)):
                broken.append((page.relative_to(root).as_posix(), target, anchor))
    assert broken == []


def test_paths_in_documents_exist(root: Path) -> None:
    """The changelog speaks of its time; all other pages of the tree as it is."""
    named = re.compile(rf"`((?:{'|'.join(FOLDERS)})/[\w./-]+)`")
    pages = [page for page in documents(root) if page.name != "CHANGELOG.md"]
    missing = [
        (page.relative_to(root).as_posix(), path)
        for page in pages
        for path in named.findall(page.read_text(encoding="utf-8"))
        if not re.search(r"N{4}|NAME|CODE", path)
        and not list(root.glob(f"{path}*" if path.startswith("docs/adr/") else path.rstrip("/")))
    ]
    assert missing == []


@pytest.mark.parametrize("folder", ["tutorial", "howto", "reference", "explanation"])
def test_the_index_of_a_folder_has_every_page(root: Path, folder: str) -> None:
    """Both the list that people read and the sidebar."""
    pages = {path.stem for path in (root / "docs" / folder).glob("*.md")} - {"index"}
    written, sidebar = (root / "docs" / folder / "index.md").read_text(encoding="utf-8").split("```{toctree}")
    assert pages <= set(re.findall(r"\]\((\w+)\.md\)", written))
    assert pages <= set(re.findall(r"^\w+$", sidebar, re.MULTILINE))


@pytest.mark.parametrize("page", ["python", "command_line"])
def test_a_page_that_is_split_by_task_has_every_part(root: Path, page: str) -> None:
    """Both the table that people read and the sidebar."""
    parts = {path.stem for path in (root / "docs" / "reference" / page).glob("*.md")}
    written, sidebar = (root / "docs" / "reference" / f"{page}.md").read_text(encoding="utf-8").split("```{toctree}")
    assert parts == set(re.findall(rf"^\| \[[^\]]+\]\({page}/(\w+)\.md\) \| .", written, re.MULTILINE))
    assert parts == set(re.findall(rf"^{page}/(\w+)$", sidebar, re.MULTILINE))
