"""The result file of a shard: which run it belongs to, which part it is, and its results.

It is written under another name and renamed when it is complete, and contains a digest of itself. If a machine
dies, a disk fills or a copy is cut short, there is no file, or one that is recognized as damaged."""

import hashlib
import json
import os
import pathlib
import socket

from shards import Shard

SCHEMA = 1


class Damaged(ValueError):
    """The file is not a complete result file."""


class Result:
    """run: must be equal in all shards of a run; content: the shard's results, independent of the machine;
    seconds: how long its parts took; where: its file, or a description of it."""

    def __init__(self, run, shard, content, seconds, where="this run"):
        self.run, self.shard, self.content, self.seconds = run, shard, content, seconds
        self.where = where


def digest(document):
    text = json.dumps(document, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def write(path, result):
    path = pathlib.Path(path)
    document = {"schema": SCHEMA, "run": result.run, "shard": str(result.shard),
                "machine": socket.gethostname(), "seconds": result.seconds,
                "content": result.content}
    # The round trip makes it what a reader gets, as numbers and keys may change their type.
    document = json.loads(json.dumps(document))
    document["digest"] = digest(document)
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(".%s.%s.%d" % (path.name, socket.gethostname(), os.getpid()))
    try:
        with open(unfinished, "w") as stream:
            json.dump(document, stream, indent=1)
            stream.write("\n")
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(unfinished, path)
    finally:
        unfinished.unlink(missing_ok=True)


def read(path):
    """Returns the Result in a file. Raises Damaged if it is incomplete, OSError if there is none."""
    data = pathlib.Path(path).read_bytes()
    try:
        document = json.loads(data)
    except ValueError:
        raise Damaged("cut short, or no result file") from None
    if not isinstance(document, dict) or "digest" not in document:
        raise Damaged("no result file of a shard")
    if document.pop("digest") != digest(document):
        raise Damaged("its digest is not that of what it holds")
    if document.get("schema") != SCHEMA:
        raise Damaged("of schema %s; this program reads %d" % (document.get("schema"), SCHEMA))
    try:
        return Result(document["run"], Shard.parse(document["shard"]), document["content"],
                      document["seconds"], str(path))
    except (KeyError, TypeError, ValueError):
        raise Damaged("it lacks what a result has") from None


def sources_digest(root, folders):
    """Returns the digest of every file in folders of the checkout: shards of different sources do not belong
    together."""
    every = hashlib.sha256()
    for folder in folders:
        for path in sorted((pathlib.Path(root) / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts and path.suffix != ".pyc":
                every.update(str(path.relative_to(root)).encode() + b"\0")
                every.update(hashlib.sha256(path.read_bytes()).digest())
    return every.hexdigest()[:16]
