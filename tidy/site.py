"""What `make docs` adds to the pages of docs/: the pages of the hunt, and pictures to turn, made by the command from the corpus.

The pages of hunt/pages stand in the site as pages/, outside of its menu but for the first, and the menu gets the pages of docs/rules.
mkdocs calls it (`hooks` in mkdocs.yml). Each page of docs/rules gets the picture of its example, a mesh that breaks the rule or
a domain at fault, and each finding that of its mesh, or of its input where the program wrote none. They are what `--html` writes, but for
the program of the page, which stands once in pictures/page.js: the site would have 120 MB otherwise.
"""
import html
import os
import pathlib
import re
import shlex
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMAND = os.environ.get("CIRCUMSPECT", str(ROOT / "build" / "release" / "bin" / "circumspect"))
CORPUS = ROOT / "corpus"
PROGRAM = re.compile(r"<script>(.*?)</script>", re.DOTALL)
PLACED = set()  # the pictures that have a place in some page
POLICY = re.compile(r'<meta http-equiv="?Content-Security-Policy"?[^>]*>')


def on_files(files, config, **_):
    """The pages of the hunt: mkdocs takes pages from docs/ alone."""
    from mkdocs.structure.files import File  # the tests of the other functions do without mkdocs
    for page in sorted((ROOT / "hunt" / "pages").glob("*.md")):
        files.append(File(f"pages/{page.name}", str(ROOT / "hunt"), config["site_dir"], config["use_directory_urls"]))
    return files


def on_page_markdown(markdown, page, **_):
    """Links between docs/ and hunt/pages as they stand in the site."""
    if page.file.src_path.startswith("pages/"):
        return markdown.replace("](../../docs/", "](../")
    return markdown.replace("../hunt/pages/", "pages/")


def rows(path):
    return [line.split("\t") for line in (CORPUS / path).read_text(encoding="utf-8").splitlines() if line]


def of_rules():
    """The words of the command for each rule and each breach: the example of its page."""
    pages = sorted((ROOT / "docs" / "rules").glob("*.md"))
    return {page.stem: shlex.split(re.search(r"^\$ circumspect (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)[1])
            for page in pages if "\n![" in page.read_text(encoding="utf-8")}


def of_findings():
    words = {}
    for name, claim, _, given, mesh, *_ in rows("findings/expected.tsv"):
        claim, kind = (claim.split(" ") + ["enclosed"])[:2]
        folder = "corpus/findings/"
        if mesh == "-":
            words[name] = (["build", "delaunay", folder + given, "--duplicates", "merge"] if claim == "delaunay"
                           else ["inspect", folder + given])
            continue
        of = (["--points", folder + given, "--duplicates", "merge"] if claim == "delaunay"
              else ["--domain", folder + given, "--domain-kind", kind])
        words[name] = ["check", folder + mesh, "--claim", claim, *of]
    return words


def frame(name, words, to):
    """Where a picture stands in a page. It is drawn while it is open, for browsers draw few pictures of space at a time."""
    PLACED.add(name)
    name = html.escape(name)
    at = f"{to}pictures/{name}.html"
    return (f'<details class="seen" ontoggle="const f = this.querySelector(\'iframe\'); f.src = this.open ? f.dataset.src : \'about:blank\'">'
            f'<summary>{words}</summary><p><a href="{at}">Alone</a></p><iframe title="{name}" data-src="{at}" '
            f'style="width:100%;height:46rem;border:1px solid"></iframe></details>')


def rules_in_menu(nav):
    """The menu, with the pages of docs/rules behind their overview: those of meshes, then those of domains."""
    names = sorted((page.stem for page in (ROOT / "docs" / "rules").glob("*.md")), key=lambda name: (name.startswith("plc."), name))
    found = []
    for entry in nav:
        title, inside = next(iter(entry.items())) if isinstance(entry, dict) else (None, entry)
        if title == "Rules":
            found.append({title: [*inside, *({name: f"rules/{name}.md"} for name in names)]})
        elif isinstance(inside, list):
            found.append({title: rules_in_menu(inside)})
        else:
            found.append(entry)
    return found


def on_config(config, **_):
    config["nav"] = rules_in_menu(config["nav"])
    return config


def on_page_content(content, page, **_):
    if page.file.src_path.startswith("rules/"):
        name = pathlib.PurePath(page.file.src_path).stem
        if name not in of_rules():
            return content
        return re.sub(r"(<p><img [^>]*></p>)", lambda match: match[1] + frame(name, "Turn it", "../"), content, count=1)
    if page.file.src_path.startswith("pages/"):
        known = of_findings()
        return re.sub(r'(<h[23] id="([\w.-]+)">.*?</h[23]>)',
                      lambda match: match[1] + (frame(match[2], "See it", "../") if match[2] in known else ""), content)
    return content


def on_post_build(config, **_):
    folder = pathlib.Path(config["site_dir"]) / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    known = {**of_rules(), **of_findings()}
    missing = [name for name in of_findings() if name not in PLACED]
    if missing:
        raise SystemExit(f"tidy/site.py: no page of hunt/pages has a heading for {', '.join(missing)}")
    for name, words in ((name, known[name]) for name in sorted(PLACED)):
        path = folder / f"{name}.html"
        path.unlink(missing_ok=True)
        subprocess.run([COMMAND, *words, "--quiet", "--html", str(path)], cwd=ROOT, check=False, stderr=subprocess.DEVNULL,
                       timeout=60)
        if not path.is_file():
            missing.append(name)
            continue
        text = path.read_text(encoding="utf-8")
        program = max(PROGRAM.findall(text), key=len)
        (folder / "page.js").write_text(program, encoding="utf-8")
        # A page that loads its program from beside it must be allowed to.
        text = POLICY.sub("", text).replace(f"<script>{program}</script>", '<script src="page.js"></script>')
        path.write_text(text, encoding="utf-8")
    if missing:
        raise SystemExit(f"tidy/site.py: {COMMAND} wrote no page of {', '.join(missing)}")
