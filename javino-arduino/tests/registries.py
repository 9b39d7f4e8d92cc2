#!/usr/bin/env python3
"""Checks the files that the Arduino Library Manager, PlatformIO and the ESP component registry read of this folder, by their rules."""
import json
import pathlib
import re
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CATEGORIES = ["Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing", "Data Storage", "Data Processing",
              "Other"]
TAKEN = ["Javino"]  # by another library


def check(condition, what):
    if not condition:
        raise AssertionError(what)


def text(name):
    return (ROOT / name).read_text()


def properties():
    return dict(line.split("=", 1) for line in text("library.properties").splitlines())


def the_library_manager_takes_the_properties():
    found = properties()
    for field in ("name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures", "includes"):
        check(found.get(field), f"library.properties has no {field}")
    check(re.fullmatch(r"[A-Za-z][A-Za-z0-9 _.-]{0,62}", found["name"]), "the name has other characters or is too long")
    check(not found["name"].lower().startswith("arduino"), "names with Arduino are Arduino's own")
    check(found["name"] not in TAKEN, f"another library is called {found['name']}")
    check(re.fullmatch(r"\d+\.\d+\.\d+", found["version"]), "the version is not one of three numbers")
    check(re.fullmatch(r"https?://[\w.-]+\.\w+(/\S*)?", found["url"]), "the url is none")
    check(found["category"] in CATEGORIES, f"there is no category {found['category']}")
    check(found["sentence"].endswith("."), "the sentence is none")
    check("arduino" not in found["maintainer"].lower(), "the maintainer is not Arduino (arduino-lint LP057)")
    check(found["sentence"] not in found["paragraph"], "the paragraph repeats the sentence (arduino-lint LP036)")
    check(re.fullmatch(r"\*|[a-z0-9_]+(,[a-z0-9_]+)*", found["architectures"]), "an architecture is none (arduino-lint LP043)")
    for header in found["includes"].split(","):
        check((ROOT / "src" / header).is_file(), f"there is no src/{header}")
    check((ROOT / "src" / (found["name"] + ".h")).is_file(), "no header has the library's name")
    for example in (ROOT / "examples").iterdir():
        check((example / f"{example.name}.ino").is_file(), f"the example {example.name} has no sketch of its name")


def all_manifests_agree():
    found, manifest, component = properties(), json.loads(text("library.json")), text("idf_component.yml")
    for field in ("name", "version"):
        check(manifest[field] == found[field], f"library.json has another {field}")
    check(f'version: "{found["version"]}"' in component, "idf_component.yml has another version")
    check(manifest["homepage"] == found["url"] and f"url: {found['url']}" in component, "the urls differ")
    check(manifest["license"] == found["license"] == "Apache-2.0", "the licences differ")
    major, minor, patch = map(int, found["version"].split("."))
    check(f"#define JAVINO_LIBRARY_VERSION {major * 10000 + minor * 100 + patch}\n" in text("src/JavinoBoard.h"), "the macro differs")
    for field in ("description", "keywords", "authors", "frameworks", "platforms", "headers"):
        check(manifest.get(field), f"library.json has no {field}")
    for name in manifest["export"]["include"]:
        check((ROOT / name).exists(), f"library.json exports {name}, which is not there")
    for header in manifest["headers"]:
        check((ROOT / "src" / header).is_file(), f"library.json has {header}, which is not there")


def the_licence_is_the_projects():
    projects = ROOT.parent / "LICENSE"  # not there where this folder is a repository of its own
    check(not projects.exists() or text("LICENSE") == projects.read_text(), "LICENSE is another one")


def the_zip_has_what_the_manifests_name():
    found, manifest = properties(), json.loads(text("library.json"))
    archive = zipfile.ZipFile(ROOT / "build" / f"{found['name']}-{found['version']}.zip")
    inside = {name.removeprefix(found["name"] + "/") for name in archive.namelist()}
    for name in manifest["export"]["include"]:
        check(any(i == name or i.startswith(name + "/") for i in inside), f"the zip has no {name}")


# ---- keywords ----

def without_comments(source):
    return re.sub(r"/\*.*?\*/|//[^\n]*|^#.*?(?<!\\)$", "", source, flags=re.S | re.M)


def public_members(source):
    """Names of the public functions and objects of the classes in a header, and of its classes and types."""
    members, types, classes, stack, statement = set(), set(), set(), [], ""
    is_public = lambda: all(kind == "class public" for kind in stack)
    access = r"\b(?:public|private|protected):"
    for token in re.findall(rf"{access}|[{{}};]|(?:(?!{access})[^{{}};])+", without_comments(source)):
        if token in ("public:", "private:", "protected:"):
            if stack:
                stack[-1] = "class " + token[:-1]
            statement = ""
        elif token in "{;":
            head = re.sub(r"\btemplate *<[^<>]*>", "", statement).strip()
            kind = re.match(r"(class|struct|enum|union|extern)\b\s*(\w*)", head)
            if kind:
                classes.add(kind[2])
            if is_public():
                if kind and kind[1] == "class" and token == "{" and not stack:
                    types.add(kind[2])
                elif head.startswith("typedef") and not stack:
                    types.add(re.findall(r"\w+", head)[-1])
                elif head.startswith("inline") and not stack:
                    members.add(re.match(r"[^(]*?(\w+)\s*\(", head)[1])
                elif stack and not kind and not head.startswith(("typedef", "friend", "static", "using")):
                    call = re.match(r"[^(]*?(\w+)\s*\(", head)
                    name = call[1] if call else (re.findall(r"\w+", head.split("=")[0]) or [None])[-1]
                    if name and "operator" not in head.split("(")[0] and name not in classes:
                        members.add(name)
            if token == "{":
                stack.append("class private" if kind and kind[1] == "class" else "other")
            statement = ""
        elif token == "}":
            stack.pop()
            statement = ""
        else:
            statement += token
    return members, types


def keywords_are_those_of_the_headers():
    members, types = set(), set()
    for header in ("JavinoBoard.h", "Javino.h", "JavinoNetwork.h", "JavinoActions.h", "JavinoArguments.h"):
        # Names that no sketch uses are left out.
        found = public_members(re.sub(r"class JavinoGathering\b.*?^};", "", text(f"src/{header}"), flags=re.S | re.M))
        members |= found[0]
        types |= found[1]
    lines = [line.split("\t") for line in text("keywords.txt").splitlines() if line]
    check(all(len(line) == 2 for line in lines), "a line of keywords.txt is not a word, a tab and a kind")
    check(len({word for word, _ in lines}) == len(lines), "a keyword is there twice")
    for kind, expected in (("KEYWORD1", types), ("KEYWORD2", members)):
        found = {word for word, k in lines if k == kind}
        check(found == expected, f"{kind}: missing {sorted(expected - found)}, not in the headers {sorted(found - expected)}")


CASES = [
    the_library_manager_takes_the_properties,
    all_manifests_agree,
    the_licence_is_the_projects,
    the_zip_has_what_the_manifests_name,
    keywords_are_those_of_the_headers,
]


def main():
    failed = 0
    for case in CASES:
        try:
            case()
            print(f"ok   {case.__name__.replace('_', ' ')}")
        except AssertionError as failure:
            failed += 1
            print(f"FAIL {case.__name__.replace('_', ' ')}: {failure}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
