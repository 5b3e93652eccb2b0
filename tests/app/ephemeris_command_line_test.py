"""`antumbra ephemeris` as its users run it: dates in, rows out, and errors that say what to change."""

import json
import math
import os
import pathlib
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["ANTUMBRA"]
HEADER = "jd_tdb,body,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,theory,error_bound_arcsec"
AU = 149597870700.0  # metres, IAU 2012 resolution B2


def run(*arguments, dates=None):
    return subprocess.run([PROGRAM, "ephemeris", *arguments], input=dates, capture_output=True,
                          text=True, timeout=60)


class EphemerisCommandLine(unittest.TestCase):
    def rows(self, *arguments, dates="2451545\n"):
        """The header, the rows as dictionaries, and what went to standard error."""
        result = run(*arguments, dates=dates)
        self.assertEqual(result.returncode, 0, result.stderr)
        header, *lines = result.stdout.splitlines()
        return header, [dict(zip(header.split(","), l.split(","))) for l in lines], result.stderr

    def refused(self, arguments, *words, dates=None):
        result = run(*arguments, dates=dates)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        for word in words:
            self.assertIn(word, result.stderr)
        return result.stderr

    def test_default_columns_from_standard_input(self):
        header, rows, errors = self.rows("--jd-tdb", "-", dates="# dates\n2451545.25 # one\n\n")
        self.assertEqual(header, HEADER)
        self.assertEqual(errors, "")
        self.assertEqual([r["body"] for r in rows],
                         ["Sun", "Moon", "Mercury", "Venus", "Mars", "Jupiter", "Saturn", "Uranus",
                          "Neptune", "Pluto"])
        self.assertTrue(all(r["jd_tdb"] == "2451545.250000000" for r in rows))
        self.assertTrue(all(r["theory"] == "de431-table" for r in rows))

    def test_distance_of_the_sun_at_perihelion(self):
        """Perihelion of 2000 January 3, 0.98332 au (Astronomical Almanac 2000)."""
        _, (sun,), _ = self.rows("--bodies", "Sun", "--jd-tdb", "-", dates="2451546.72\n")
        distance = math.hypot(*(float(sun[c]) for c in ("x_m", "y_m", "z_m"))) / AU
        self.assertAlmostEqual(distance, 0.98332, delta=1e-5)

    def test_json_holds_the_same_numbers(self):
        _, (row,), _ = self.rows("--bodies", "Mars", "--jd-tdb", "-")
        result = run("--bodies", "Mars", "--jd-tdb", "-", "--format", "json", dates="2451545\n")
        document = json.loads(result.stdout)
        self.assertEqual((document["center"], document["frame"], document["correction"]),
                         ("Earth", "icrf", "geometric"))
        (item,) = document["rows"]
        self.assertEqual(list(item), HEADER.split(","))
        self.assertAlmostEqual(item["x_m"], float(row["x_m"]), delta=1e-3)

    def test_horizontal_at_a_site(self):
        """In totality at Luxor, 2027-08-02, Sun and Moon stand together, high in the sky."""
        header, (sun, moon), _ = self.rows(
            "--bodies", "Sun,Moon", "--frame", "horizontal", "--correction", "apparent",
            "--site=25.687,32.640,76", "--jd-ut1", "-", dates="2461619.918\n")
        self.assertEqual(header, "jd_ut1,body,az_deg,alt_deg,distance_au,delta_t_s,theory,"
                                 "error_bound_arcsec")
        self.assertGreater(float(sun["alt_deg"]), 80.0)
        self.assertAlmostEqual(float(sun["alt_deg"]), float(moon["alt_deg"]), delta=0.05)

    def test_equator_of_date(self):
        """Equinox of March 2000, 20 07:35 UT (Astronomical Almanac): the Sun crosses the equator."""
        header, (sun,), _ = self.rows("--bodies", "Sun", "--frame", "equatorial-of-date",
                                      "--correction", "apparent", "--jd-tt", "-",
                                      dates="2451623.8167\n")
        self.assertEqual(header, "jd_tt,body,ra_deg,dec_deg,distance_au,theory,error_bound_arcsec")
        # A minute of time moves its declination by 0.0003 degrees.
        self.assertAlmostEqual(float(sun["dec_deg"]), 0.0, delta=0.0005)

    def test_moons_say_that_a_fit_answered(self):
        _, rows, _ = self.rows("--bodies", "Io,Europa", "--center", "Jupiter.center", "--jd-tdb", "-")
        # Mean distances 421 800 and 671 100 km, eccentricities 0.004 and 0.009 (JPL).
        for row, distance, part in zip(rows, (4.218e8, 6.711e8), (0.006, 0.012)):
            self.assertEqual(row["theory"], "de431-table+moons-fit")
            length = math.hypot(*(float(row[c]) for c in ("x_m", "y_m", "z_m")))
            self.assertAlmostEqual(length / distance, 1.0, delta=part)

    def test_a_request_the_theory_cannot_meet_is_said(self):
        _, rows, errors = self.rows("--error", "5arcsec", "--bodies", "Sun,Moon,Mercury,Jupiter",
                                    "--jd-tdb", "-", dates="2451545\n1000000\n1000001\n")
        # A line for each body with such a row, and no other.
        unmet = {r["body"] for r in rows if float(r["error_bound_arcsec"]) > 5.0}
        self.assertIn("Jupiter", unmet)
        warned = {line.split("--error: ")[1].split(":")[0]: line for line in errors.splitlines()}
        self.assertEqual(set(warned), unmet)
        self.assertEqual(len(errors.splitlines()), len(unmet))
        for word in ("warning", "5 arcsec", "-:2", "1000000 TDB", "72.0000"):
            self.assertIn(word, warned["Jupiter"])
        _, _, errors = self.rows("--theory", "series", "--error", "0.001arcsec", "--bodies", "Sun",
                                 "--jd-tdb", "-")
        self.assertIn("Sun", errors)
        self.assertIn("0.001 arcsec", errors)
        _, _, errors = self.rows("--error", "5arcsec", "--bodies", "Jupiter", "--jd-tdb", "-")
        self.assertEqual(errors, "")

    def test_every_step_is_a_row(self):
        _, rows, _ = self.rows("--bodies", "Moon", "--from", "2451545 TDB", "--to", "2451546 TDB",
                               "--step", "2.5e-1")
        self.assertEqual(len(rows), 5)
        ends = ("--bodies", "Moon", "--from", "2451545 TDB", "--to", "2451546 TDB")
        self.refused([*ends, "--step", "1e-12"], "--step", "1e-12", "at most")
        self.refused([*ends, "--step=-1"], "--step", '"-1"', "not positive")
        self.refused([*ends, "--step", "nan"], "--step", "finite")

    def test_refuses_bad_dates(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refused(["--jd-tdb", folder], "--jd-tdb", folder, "folder")
            empty = pathlib.Path(folder) / "empty.txt"
            empty.write_text("# none\n")
            self.refused(["--jd-tdb", str(empty)], "empty.txt", "no date")
        self.refused(["--jd-tdb", "-"], "-:2", "nan", dates="2451545\nnan\n")
        self.refused(["--jd-tdb", "/nonexistent"], "/nonexistent", "cannot be read")

    def test_refuses_dates_outside_the_span(self):
        self.refused(["--jd-ut1", "-"], "-:3", "9e6 UT1", "-3000", "3001", "--extrapolate",
                     dates="# head\n2451545\n9e6\n")
        message = self.refused(["--theory", "table", "--jd-tdb", "-"], "-:1", "2000000.5 TDB",
                               "1800", "2400", dates="2000000.5\n")
        self.assertNotIn("--extrapolate", message)
        _, rows, _ = self.rows("--bodies", "Sun", "--extrapolate", "--jd-tdb", "-", dates="3e6\n")
        self.assertEqual(rows[0]["theory"], "vsop87+elpmpp02+extrapolated")

    def test_refuses_bad_and_conflicting_options(self):
        date = dict(dates="2451545\n")
        self.refused(["--bodies", "Vulcan", "--jd-tdb", "-"], "--bodies", "Vulcan", "Mercury", **date)
        self.refused(["--jd-tdb", "-", "--jd-tt", "-"], "--jd-tdb", "--jd-tt", **date)
        self.refused([], "--jd-tdb", "--from")
        self.refused(["--jd-tdb", "-", "--theory", "table", "--error", "1arcsec"], "--error", **date)
        self.refused(["--jd-tdb", "-", "--error", "0arcsec"], "--error", "positive", **date)
        self.refused(["--jd-tdb", "-", "--frame", "horizontal"], "--site", **date)
        self.refused(["--jd-tdb", "-", "--format", "xml"], "--format", "json", **date)
        for bad in ("nan", "inf", "2e6", "-1000001"):
            self.refused(["--jd-ut1", "-", f"--delta-t={bad}"], "--delta-t", bad, **date)

    def test_help_says_what_an_error_is(self):
        result = run("--help")
        self.assertEqual(result.returncode, 0)
        text = " ".join(result.stdout.split())
        for word in ("truncation", "error_bound_arcsec", "DE431", "warning"):
            self.assertIn(word, text)

    def test_starts_within_half_a_second(self):
        times = []
        for _ in range(5):
            before = time.perf_counter()
            self.rows("--bodies", "Sun", "--jd-tdb", "-")
            times.append(time.perf_counter() - before)
        print(f"ephemeris --bodies Sun, one date, whole process: {min(times) * 1e3:.0f} ms "
              f"(least of 5), {max(times) * 1e3:.0f} ms (most)")
        self.assertLess(min(times), 0.5)


if __name__ == "__main__":
    unittest.main()
