#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints as users meet them: iout(41), a signal, a kill, a damaged file, another deck."""
import hashlib
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import unittest

import numpy

from full_length import FULL
from program import DECKS, ProgramTest, history, netcdf, records, sets
from waiting import wait_until

KILLS = 50 if FULL else 8

# A run of some seconds, with 1430 records and 71 snapshots, or of the half.
LONG = (DECKS / "sod.in", *sets(**{"in__nx": 201, "in__tstep": 5e-6, "in__iout(33)": 1, "in__tiout(33)": 1e-4,
                                   "in__iout(13)": 1, "in__tiout(13)": 2e-3, "in__tmax": 0.143 if FULL else 0.0715}))


def number_of(checkpoint):
    return int(re.fullmatch(r"checkpoint-(\d+)", checkpoint.stem)[1])


def checkpoints(folder):
    """The folder's checkpoints, the newest first."""
    return sorted(folder.glob("checkpoint-*.nc"), key=number_of, reverse=True)


def is_whole(path):
    """Whether the checksum in the file fits the file, as anyone may check it."""
    data = path.read_bytes()
    told = re.search(rb"checksum\0\0\0\x02\0\0\0\x40([0-9a-f]{64})", data)
    return hashlib.sha256(data.replace(told[1], b"0" * 64, 1)).hexdigest().encode() == told[1]


class Restart(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """The long run that nothing stops, once for all tests."""
        super().setUpClass()
        cls.whole = ProgramTest.shared_by(cls).run_ok(*LONG)

    def start_long(self, *options, out="out"):
        """Starts the long run; returns its process and folder."""
        folder = self.folder / out
        return self.start(*LONG, "--out", folder, "--quiet", *options), folder

    def stopped(self, *options, out="out", number=signal.SIGTERM):
        """The folder of the long run, which a signal has stopped after some records, and what it said."""
        process, folder = self.start_long(*options, out=out)
        wait_until(lambda: records(folder) > 100, "the hundredth record", process)
        return folder, self.stop(process, number)[1]

    def same_numbers(self, parts):
        for name in ("history.nc", "particles.nc", "mesh.nc"):
            left, right = netcdf(self.whole / name), netcdf(parts / name)
            self.assertEqual(left.keys(), right.keys())
            for variable in left:
                self.assertEqual(left[variable].tobytes(), right[variable].tobytes(), f"{variable} of {name}")

    def test_a_signal_ends_the_run_with_a_checkpoint_from_which_it_goes_on(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            folder, stderr = self.stopped(out=number.name, number=number)
            newest = checkpoints(folder)[0]
            self.assertIn(f"the same command goes on with --restart {newest}", stderr)
            self.assertFalse((folder / "summary.txt").exists())
            self.run_ok(*LONG, "--restart", newest, out=number.name)
            self.same_numbers(folder)
            self.assertIn("goes on from", (folder / "messages.txt").read_text())
            self.assertEqual(list(folder.glob("*.earlier")), [])

    def test_a_signal_leaves_the_decks_that_follow_alone(self):
        process, folder = self.start_long(DECKS / "spring-mass.in")
        wait_until((folder / "sod" / "history.txt").exists, "the history", process)
        self.stop(process)
        self.assertFalse((folder / "spring-mass").exists())

    def test_after_a_kill_the_newest_checkpoint_loads_and_the_history_reads_up_to_it(self):
        """The run writes checkpoints all the time, and is killed at some moment after the one that was drawn."""
        draw = random.Random(41)
        options = sets(**{"in__iout(41)": 1, "in__tiout(41)": 5e-5})
        for kill in range(KILLS):
            process, folder = self.start_long(*options, "--threads", 1 + kill % 2, out=f"kill-{kill}")
            drawn = draw.randrange(60)
            wait_until(lambda: not drawn or any(number_of(path) >= drawn for path in checkpoints(folder)),
                       f"checkpoint {drawn}", process)
            self.stop(process, signal.SIGKILL)
            found = checkpoints(folder)
            self.assertTrue(found or not drawn)
            self.assertLessEqual(len(found), 3)  # the third is removed after the new one is in its place
            for path in found:
                self.assertTrue(is_whole(path), f"kill {kill}: {path}")
                self.expect(0, *LONG, *options, "--restart", path, "--dry-run", "--quiet")
            if found:
                kept = netcdf(found[0])["history"]
                columns = history(folder, killed=True)
                self.assertTrue(numpy.array_equal(kept.T, [column[:len(kept)] for column in columns.values()]))
                self.assertTrue(numpy.array_equal(netcdf(folder / "history.nc")["time"][:len(kept)], kept[:, 0]))

    def test_a_kill_during_the_restart_costs_nothing(self):
        folder, _ = self.stopped()
        newest, kept = checkpoints(folder)[0], records(folder)
        lock, messages = folder / "lock", folder / "messages.txt"
        text = lambda path: path.read_text() if path.exists() else ""
        goes_on = lambda: "goes on from" in text(messages)
        for what, is_seen in (("a process", lambda _: True),
                              ("its number in the lock", lambda process: f"process {process.pid} " in text(lock)),
                              ("its messages", lambda _: messages.exists()),
                              ("its first record", lambda _: records(folder) > 0),
                              ("the remark that it goes on", lambda _: goes_on()),
                              ("all snapshots that it takes over", lambda _: goes_on() and not [*folder.glob("*.earlier")]),
                              ("a new record", lambda _: records(folder) > kept)):
            for name in ("messages.txt", "history.txt"):
                (folder / name).unlink(missing_ok=True)
            process, _ = self.start_long("--restart", newest)
            wait_until(lambda: is_seen(process), what, process)
            self.stop(process, signal.SIGKILL)
        self.run_ok(*LONG, "--restart", newest, out="out")
        self.same_numbers(folder)

    def test_a_switch_writes_them_and_the_two_newest_stay(self):
        deck = DECKS / "spring-mass.in"
        folder = self.run_ok(deck, *sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.01}))
        self.assertEqual([path.name for path in checkpoints(folder)], ["checkpoint-11.nc", "checkpoint-10.nc"])
        state = [netcdf(path) for path in checkpoints(folder)]
        self.assertEqual([round(float(values["state_time"][0]), 4) for values in state], [0.101, 0.1])
        self.assertEqual(self.expect(2, deck, *sets(**{"in__iout(41)": 1})).stderr.count("needs its interval"), 1)

    def test_a_finished_run_can_be_made_longer(self):
        deck = DECKS / "spring-mass.in"
        options = sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.02, "in__iout(33)": 1, "in__tiout(33)": 0.001})
        folder = self.run_ok(deck, *options)
        newest = checkpoints(folder)[0]
        before = history(folder)["time"]
        self.run_ok(deck, *options, "--restart", newest, *sets(in__tmax=0.15))
        after = history(folder)["time"]
        self.assertTrue(numpy.array_equal(after[:len(before)], before))
        self.assertEqual(after[-1], 0.15)

    def test_another_folder_gets_all_of_it(self):
        folder, _ = self.stopped()
        before = (folder / "history.txt").read_bytes()
        self.run_ok(*LONG, "--restart", checkpoints(folder)[0], out="elsewhere")
        self.same_numbers(self.folder / "elsewhere")
        self.assertEqual((folder / "history.txt").read_bytes(), before)

    def test_lost_snapshots_are_told_and_the_run_goes_on(self):
        folder, _ = self.stopped()
        (folder / "particles.nc").write_bytes(b"no NetCDF")
        result = self.expect(0, *LONG, "--out", folder, "--restart", checkpoints(folder)[0])
        self.assertRegex(result.stderr, r"\b([1-9]\d*) of \1 earlier snapshots are lost")

    def with_snapshots(self):
        """A finished run with snapshots, its options, and a copy of its older checkpoint in another folder."""
        options = sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.02, "in__iout(13)": 1, "in__tiout(13)": 0.01})
        deck = DECKS / "spring-mass.in"
        folder = self.run_ok(deck, *options)
        return folder, (deck, *options), shutil.copy(checkpoints(folder)[1], self.folder)

    def test_a_copied_or_linked_checkpoint_finds_the_snapshots(self):
        folder, words, copy = self.with_snapshots()
        before = netcdf(folder / "particles.nc")["x"].tobytes()
        link = self.folder / "link.nc"
        link.symlink_to(checkpoints(folder)[0])
        for path in (link, copy):
            self.run_ok(*words, "--restart", path)
            self.assertEqual(netcdf(folder / "particles.nc")["x"].tobytes(), before)

    def test_snapshots_of_another_run_are_not_taken_over(self):
        folder, words, older = self.with_snapshots()
        for other in (sets(in__gravc=-100.0), sets(in__xright=0.4, in__nx=5)):
            self.run_ok(*words, *other, *sets(**{"in__iout(41)": 0}))
            foreign = (folder / "particles.nc").read_bytes()
            result = self.expect(0, *words, "--out", folder, "--restart", older)
            self.assertIn("earlier snapshots are lost", result.stderr)
            self.assertIn("is of another run; what is there stays as", result.stderr)
            self.assertEqual((folder / "particles.nc.unused").read_bytes(), foreign)

    def test_a_full_disk_during_the_restart_loses_nothing(self):
        folder, words, older = self.with_snapshots()
        whole = netcdf(folder / "particles.nc")["x"].tobytes()
        room = (folder / "particles.nc").stat().st_size // 2
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))
        self.expect(4, *words, "--out", folder, "--quiet", "--restart", older, before=limit)
        self.run_ok(*words, "--restart", older)
        self.assertEqual(netcdf(folder / "particles.nc")["x"].tobytes(), whole)
        self.assertEqual([*folder.glob("*.earlier"), *folder.glob("*.unused")], [])

    def with_checkpoints(self):
        deck = DECKS / "spring-mass.in"
        options = sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.02})
        return deck, options, checkpoints(self.run_ok(deck, *options))

    def test_a_damaged_one_is_refused_and_the_older_offered(self):
        deck, options, (newest, older) = self.with_checkpoints()
        data = bytearray(newest.read_bytes())
        data[len(data) // 2] ^= 1
        newest.write_bytes(data)
        before = sorted(os.listdir(newest.parent))
        result = self.expect(4, deck, *options, "--out", newest.parent, "--restart", newest)
        self.assertIn(f"{newest}: it is damaged: its checksum does not fit; {older.name} is whole", result.stderr)
        self.assertIn(f"--restart {older}", result.stderr)
        self.assertEqual(sorted(os.listdir(newest.parent)), before)

    def test_the_checkpoint_of_another_run_is_refused(self):
        deck, options, (newest, _) = self.with_checkpoints()
        summary = (newest.parent / "summary.txt").read_bytes()
        result = self.expect(2, deck, *options, "--out", newest.parent, "--restart", newest,
                             *sets(in__nx=3, in__gravc=-10.0))
        self.assertRegex(result.stderr, r"in\.nx was \d+ in the run of the checkpoint and is 3 in the deck")
        self.assertIn("in.gravc was", result.stderr)
        self.assertIn("only in.tmax, in.iout but 38, and in.tiout may differ", result.stderr)
        self.assertEqual((newest.parent / "summary.txt").read_bytes(), summary)
        other = self.expect(2, DECKS / "string-mass.in", "--restart", newest, "--out", self.folder / "other")
        self.assertIn("particle data", other.stderr)
        self.assertFalse((self.folder / "other").exists())

    def test_a_static_run_keeps_its_end(self):
        """Its loads grow until tmax: another end would change the load that the checkpoint has."""
        deck, options = DECKS / "flag.in", sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.25})
        newest = checkpoints(self.run_ok(deck, *options))[0]
        result = self.expect(2, deck, *options, "--restart", newest, "--out", self.folder / "longer", *sets(in__tmax=2.0))
        self.assertRegex(result.stderr, r"in\.tmax was 1\S* in the run of the checkpoint and is 2\S* in the deck")

    def test_what_is_no_checkpoint_is_refused(self):
        deck = DECKS / "spring-mass.in"
        for path, words in ((deck, "it is no checkpoint"), (self.folder / "nowhere.nc", "cannot be opened")):
            result = self.expect(4, deck, "--restart", path, "--out", self.folder / "out")
            self.assertIn(words, result.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_restart_is_of_one_deck(self):
        result = self.expect(2, DECKS / "sod.in", DECKS / "spring-mass.in", "--restart", "x.nc")
        self.assertIn("--restart goes with one deck", result.stderr)
        self.assertIn("requires deck", self.expect(2, "--restart", "x.nc").stderr)
        self.assertIn("a file is wanted", self.expect(2, DECKS / "sod.in", "--restart", "").stderr)

    def test_a_folder_is_no_checkpoint_but_has_some(self):
        deck, options, (newest, _) = self.with_checkpoints()
        result = self.expect(4, deck, *options, "--restart", newest.parent)
        self.assertIn(f"is a folder; {newest.name} is whole", result.stderr)
        self.assertIn(f"--restart {newest}", result.stderr)

    def test_an_end_before_the_checkpoint_is_refused(self):
        deck, options, (newest, _) = self.with_checkpoints()
        result = self.expect(2, deck, *options, "--restart", newest, *sets(in__tmax=0.05), "--out", newest.parent)
        self.assertIn("the checkpoint is of t = 0.101, after tmax = 0.05", result.stderr)
        self.assertTrue((newest.parent / "summary.txt").exists())

    def test_a_lost_point_names_the_last_checkpoint(self):
        options = sets(**{"mpm__cfl": 0, "in__tstep": 1.7e-5, "in__dtmax": 1.7e-5, "in__iout(41)": 1,
                          "in__tiout(41)": 5e-5})
        folder = self.folder / "out"
        result = self.expect(3, DECKS / "piston-m1.in", *options, "--out", folder)
        newest = checkpoints(folder)[0]
        self.assertIn(f"last good checkpoint: {newest} (t = ", result.stderr)
        self.assertIn("last good checkpoint", (folder / "messages.txt").read_text())

    def test_a_new_run_leaves_the_checkpoints_of_the_one_before_until_it_has_its_own(self):
        deck, options, found = self.with_checkpoints()
        names = [path.name for path in found]
        folder = self.run_ok(deck)
        self.assertEqual([path.name for path in checkpoints(folder)], names)
        self.run_ok(deck, *options)
        self.assertEqual([path.name for path in checkpoints(folder)], ["checkpoint-12.nc", "checkpoint-11.nc"])


if __name__ == "__main__":
    unittest.main()
