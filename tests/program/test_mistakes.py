#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes as users make them: what is no text, habits of other codes, many at once, and names without end."""
import unittest

from full_length import FULL
from program import DECKS, ProgramTest, diagnostics

SOUND = """a block
$in
 nx=11, ny=11, igen=1,
 xleft=0.0, xright=1.0, ybot=0.0, ytop=1.0,
 tmax=0.01, tstep=1.d-3
$
$reg
 nreg=1,
 nvi=4,
 xvi(1,1)=0.0,0.5,0.5,0.0,
 yvi(1,1)=0.0,0.0,0.5,0.5,
 nprg=4,
 densir(1)=1.0,
 matr(1,1)=1.0,0.3,
 ipath(4,1)=0
$
"""
FILE_DECK = SOUND[:SOUND.index("$reg")].replace("igen=1", "igen=0")
POINTS = """0.1
1.0d6,0.0d0,10.d25,2.d25,1.0d25,1.d2,0.d0
3,3,3,8
4
4,3
0.5 0.9 0.0 0.0 0.0 0.0 0.0
0.5 0.8 0.0 0.0 0.0 0.0 0.0
0.5 0.7 0.0 0.0 0.0 0.0 0.0
0.5 0.8 0.0 0.0 0.0 0.0 0.0
"""


class Mistakes(ProgramTest):
    ASKED = ("plan", "check")  # next to the run itself

    def errors(self, deck, *words):
        """The errors that a deck is refused with, in order; all commands refuse it alike, and nothing is written."""
        if isinstance(deck, str):
            deck = self.write("deck.in", deck)
        before = sorted(self.folder.iterdir())
        told = self.expect(2, deck, *words, folder=self.folder).stderr
        for command in self.ASKED:
            self.assertEqual(self.expect(2, command, deck, *words).stderr, told)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        return [(head["text"], "\n".join(below)) for head, below in diagnostics(told) if head["severity"] == "error"]

    def the_error(self, deck, *words):
        """Its only one, with what stands below."""
        errors = self.errors(deck, *words)
        self.assertEqual(len(errors), 1, errors)
        return "\n".join(errors[0])


class OneMistake(Mistakes):
    def test_what_follows_from_a_wrong_choice_is_not_reported(self):
        """That jet_on(1) is not given once followed the error that says what is wrong with it."""
        text = (DECKS / "coupled-paddle.in").read_text()
        wrong = text.replace("jet_on(1)='left'", "jet_on(1)='1.left'")
        self.assertNotEqual(wrong, text)
        told = self.errors(wrong)
        self.assertEqual([message for message, _ in told], ["jet_on(1) = '1.left' is none of its choices"])


class NoText(Mistakes):
    def test_what_is_no_text_is_told_by_its_kind(self):
        run = self.run_ok(self.write("block.in", SOUND))
        kinds = {"UTF-16": SOUND.encode("utf-16"), "in UTF-16,": SOUND.encode("utf-16-le"), "UTF-16, no": SOUND.encode("utf-16-be"),
                 "the file is empty": b"", "nothing but blanks": b" \n\t\r\n\n", "a NetCDF file": (run / "history.nc").read_bytes(),
                 "a binary file": bytes(range(256)) * 20, "compressed": b"\x1f\x8b\x08\x00abc"}
        for kind, data in kinds.items():
            path = self.folder / "no_text.in"
            path.write_bytes(data)
            self.assertIn(kind, self.the_error(path))
            if kind != "nothing but blanks":
                deck = self.write("points.in", FILE_DECK)
                self.assertIn(kind, self.the_error(deck, "--particles", path))

    def test_a_text_with_an_odd_byte_is_a_text(self):
        self.assertIn("0x00", self.the_error(SOUND.replace("nx=11", "nx=11\0")))

    def test_a_binary_mesh_is_told_once(self):
        header = b"$MeshFormat\n4.1 1 8\n" + b"\1\0\0\0\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"x\"\n$EndPhysicalNames\n"
        for beginning in (header, b"$Comments\nby hand\n$EndComments\n" + header):
            (self.folder / "binary.msh").write_bytes(beginning + b"$Entities\n" + bytes(range(256)) * 9 + b"$EndEntities\n$Nodes\n\n$No")
            told = self.the_error(FILE_DECK.replace("igen=0", "igen=1") + "$mesh file='binary.msh' $\n$reg nreg=1, densir(1)=1., "
                                  "matr(1,1)=1.,.3 $\n")
            self.assertIn("this is a binary file", told)
            self.assertIn("without -bin", told)
            self.assertIn("makes one of it", told)


class Habits(Mistakes):
    ASKED = Mistakes.ASKED if FULL else ()  # many mistakes of grammar, in which commands do not differ

    def test_decimal_commas(self):
        for line, right in (("tmax=0,01", "0.01"), ("tmax=-0,5e-3", "-0.5e-3"), ("gravc=9,81, tmax=0.1", "9.81")):
            self.assertIn(f"A decimal point is '.': {right}", self.the_error(SOUND.replace("tmax=0.01", line)))
        result = self.expect(0, "plan", self.write("array.in", SOUND.replace("nprg=4", "vrx(1)=0,01, nprg=4")))
        self.assertIn("warning: '0,01' is read as two values", result.stderr)
        self.assertNotIn("two values", self.expect(0, "plan", self.write("sound.in", SOUND.replace("0.0,0.5,0.5,0.0", "0,.5,.5,0"))).stderr)

    def test_comments_of_other_languages(self):
        for comment, mark in (("C a comment", "C"), ("c x = 5", "c"), ("C", "C"), ("# a comment, x = 3", "#"), ("  * stars", "*"),
                              ("// slashes", "//"), ("*", "*")):
            for place in ("$reg\n", " nvi=4,\n", " nprg=4,\n")[:3 if FULL else 2]:
                told = self.the_error(SOUND.replace(place, f"{place}{comment}\n"))
                self.assertIn(f"'{mark}' begins no comment", told)
                self.assertIn("A comment begins with '!'.", told)

    def test_names_of_other_codes(self):
        for group, name, right in (("in", "dt", "tstep"), ("in", "t_end", "tmax"), ("in", "EndTime", "tmax"), ("in", "dx", "nx"),
                                   ("in", "xmin", "xleft"), ("in", "gravity", "gravc"), ("in", "dt_out", "tiout"),
                                   ("reg", "rho(1)", "densir"), ("reg", "density(1)", "densir"), ("reg", "E", "matr"),
                                   ("reg", "young", "matr"), ("reg", "nu", "matr"), ("reg", "poisson", "matr"),
                                   ("reg", "ppc", "nprg"), ("reg", "vx", "vrx")):
            with self.subTest(name=name):
                told = self.the_error(SOUND.replace(f"${group}\n", f"${group}\n {name}=0.5\n"))
                self.assertIn(f"It is '{right}' (group ${group}) here", told)
        told = self.the_error(SOUND + "$membrane\n rho(1)=1., $\n")
        self.assertIn("It is 'density' (group $membrane) here", told)

    def test_what_a_name_of_another_code_stands_for_is_not_missed_as_well(self):
        for given, other in (("tstep=1.d-3", "dt=1.d-3"), ("tmax=0.01", "tend=0.01"), ("densir(1)=1.0", "rho(1)=1.0"),
                             ("nx=11", "nxx=11")):
            self.assertIn("has no variable", self.the_error(SOUND.replace(given, other)))


class ManyAtOnce(Mistakes):
    def test_mistakes_of_grammar_values_and_regions_are_told_together(self):
        """One of each kind: the deck lacks a clock, so that there is no scene, and its region is looked at all the same."""
        deck = SOUND.replace("tstep=1.d-3", "gravc=down").replace("0.0,0.5,0.5,0.0", "0.0,0.5,0.0,0.5")
        deck = deck.replace("nprg=4", "nprg=5")
        deck = deck.replace("densir(1)=1.0", "densir(1)=-1.0").replace("matr(1,1)=1.0", "matr(1,1)=0.0").replace("ytop=1.0", "top=1.0")
        texts = [text for text, _ in self.errors(deck)]
        wanted = ["$in has no variable 'top'", "gravc must be a number, not 'down'", "densir(1) = -1 is out of range",
                  "$in lacks tstep, which has no default", "region 1: nprg = 5 is no square",
                  "region 1: an elastic solid needs Young's modulus > 0, not 0"]
        for text in wanted:
            self.assertEqual(texts.count(text), 1, texts)
        self.assertTrue(any("its outline crosses itself" in text for text in texts), texts)
        self.assertEqual(len(texts), len(wanted) + 1, texts)

    def test_a_wrong_grid_hides_no_region(self):
        texts = [text for text, _ in self.errors(SOUND.replace("xright=1.0", "xright=-1.0").replace("nprg=4", "nprg=5"))]
        self.assertEqual(texts, ["xright = -1 is not above xleft = 0", "region 1: nprg = 5 is no square"])

    def test_a_particle_file_is_looked_at_though_the_deck_is_incomplete(self):
        points = self.write("x.par", POINTS.replace("3,3,3,8", "3,3,8"))
        texts = [text for text, _ in self.errors(FILE_DECK.replace("tmax=0.01,", ""), "--particles", points)]
        self.assertEqual(texts, ["$in lacks tmax, which has no default", "this line of the particle data must be 4 integers ipath"])

    def test_nothing_is_told_twice(self):
        for wrong in ("densir(1)=x", "densir(1)=-1.", "densir(1)=1.,,=3"):
            self.assertEqual([text for text, _ in self.errors(SOUND.replace("densir(1)=1.0", wrong)) if "is not given" in text], [])
        self.assertIn("a polygon has at least 3 vertices", self.the_error(SOUND.replace("nvi=4", "nvi=2")))


class Points(Mistakes):
    def test_two_rows_in_one_place(self):
        told = self.the_error(self.write("deck.in", FILE_DECK), "--particles", self.write("x.par", POINTS))
        self.assertIn("point 4 at (0.5, 0.8) is where point 2 is", told)
        self.assertIn("x.par:9:1", self.expect(2, "plan", self.folder / "deck.in", "--particles", self.folder / "x.par").stderr)
        rows = POINTS.replace("0.5 0.7", "0.5 0.9")
        told = self.the_error(self.write("deck.in", FILE_DECK), "--particles", self.write("x.par", rows))
        self.assertIn("point 3 at (0.5, 0.9) is where point 1 is; so are 1 more", told)

    def test_the_printed_files_have_none(self):
        for name in ("pendulum-40", "spring-mass", "string-mass", "stability-side", "noise"):
            self.expect(0, "plan", DECKS / f"{name}.in")


class Lengths(Mistakes):
    LONG = "a" * 50_000 + "b" * 50_000

    def test_names_without_end_are_shortened_in_the_middle(self):
        deck = self.write("deck.in", SOUND)
        for code, words in ((2, (self.write("v.in", SOUND.replace("nprg=", self.LONG + "=")),)), (2, (deck, "--set", f"in.{self.LONG}=1")),
                            (2, (self.write("g.in", SOUND + f"${self.LONG} $\n"),)), (2, ("vars", self.LONG)), (2, (self.LONG,)),
                            (4, (self.LONG + ".in",)), (2, (deck, f"--{self.LONG}")), (2, (deck, "--path", self.LONG)),
                            (2, (self.write("c.in", SOUND.replace("tmax", f"units='{self.LONG}', tmax")),)),
                            (2, (self.write("p.in", FILE_DECK.replace("tmax", f"particles='{self.LONG}', tmax")),)),
                            (2, (self.write("f.in", FILE_DECK), "--particles", self.LONG)), (2, (self.write("n.in", SOUND.replace("11", "1" * 100_000)),)),
                            (4, (deck, "--restart", self.LONG)), (4, (deck, "--out", f"{self.folder}/{self.LONG}"))):
            with self.subTest(words=[str(word)[:40] for word in words]):
                told = self.expect(code, *words, folder=self.folder).stderr
                self.assertLess(max(map(len, told.split())), 400)
                self.assertIn("...", told)
        told = self.expect(2, "check", self.folder / "v.in").stderr
        self.assertRegex(told, r"'a{29}\.\.\.b{28}'")


if __name__ == "__main__":
    unittest.main()
