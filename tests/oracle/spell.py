# SPDX-License-Identifier: GPL-3.0-or-later
"""Spellings of values, comments and separators, at random."""
from table import ANY, NOT_NEGATIVE, POSITIVE

BLANKS = (" ", "  ", "\t", " \t ")
HARD_REALS = ("9007199254740993", "1.7976931348623157e308", "2.2250738585072011e-308", "4.9e-324", "1e-400", "0.1",
              "5e-324", "2.2250738585072014d-308", "0.500000000000000166533453693773481063544750213623046875",
              "1.00000000000000011102230246251565404236316680908203126", "123456789012345678901234567890", "0e999")
COMMENTS = ("", " note", " it's 5/6", ' "quoted', " $ & / = , ;", " $end", " x=3, y(2)=4", "!!", "\t#", " \u00b5m")


def digits(rng, least, most):
    return "".join(rng.choice("0123456789") for _ in range(rng.randint(least, most)))


def exponent(rng):
    size = rng.choice((rng.randint(0, 9), rng.randint(0, 9), rng.randint(10, 250)))
    sign = rng.choice(("", "+", "-"))
    spelled = f"{size:0{rng.choice((1, 2, 3))}}"
    if rng.random() < 0.2:
        return (sign or "+") + spelled  # 1.5+3
    return rng.choice("eEdDqQ") + sign + spelled


def mantissa(rng):
    return rng.choice((digits(rng, 1, 6), digits(rng, 1, 3) + ".", "." + digits(rng, 1, 6),
                       digits(rng, 1, 4) + "." + digits(rng, 1, 4), digits(rng, 1, 9) + "." + digits(rng, 9, 25)))


def real(rng, allowed):
    if allowed == (0, 1):
        return rng.choice(("0", "1", "0.", "1.", "+1.0e0", ".1d1", "10.q-1", "0.0+5", "01.00"))
    if allowed == ANY and rng.random() < 0.05:
        return rng.choice(("", "+", "-")) + rng.choice(HARD_REALS)
    sign = rng.choice(("", "", "+", "-")) if allowed == ANY else rng.choice(("", "", "+"))
    number = mantissa(rng)
    if allowed == POSITIVE and not number.strip("0."):
        number = "1" + number
    return sign + number + (exponent(rng) if rng.random() < 0.5 else "")


def zeros(rng):
    return rng.choice(("", "", "", "0", "00"))


def integer(rng, allowed):
    if allowed == ANY:
        number = rng.choice((rng.randint(0, 99), rng.randint(0, 2147483646)))
        return rng.choice(("", "", "+", "-")) + zeros(rng) + str(number)
    return rng.choice(("", "", "+")) + zeros(rng) + str(rng.choice(allowed))


def logical(rng):
    word = rng.choice(("t", "true", "truly", "tea", "f", "false", "fal", "falsehood"))
    dots = rng.choice((("", ""), (".", "."), (".", "")))
    return any_case(rng, dots[0] + word + dots[1])


def text(rng):
    quote = rng.choice("'\"")
    letters = " abcXYZ/!$&,;=()*.:-_019\t'\"\xe9"
    content = "".join(rng.choice(letters) for _ in range(rng.randint(0, 18)))
    if rng.random() < 0.1:
        content += "\n" + rng.choice(("z", "  z", "/z"))
    return quote + content.replace(quote, 2 * quote) + quote


def value(rng, kind, allowed):
    if kind == "logical":
        return logical(rng)
    if kind == "text":
        return text(rng)
    return real(rng, allowed) if kind == "real" else integer(rng, allowed)


def any_case(rng, word):
    mixed = "".join(rng.choice((letter, letter.upper())) for letter in word)
    return rng.choice((word, word, word.upper(), word.title(), mixed))


def blanks(rng, likely=0.3):
    return rng.choice(BLANKS) if rng.random() < likely else ""


def comment(rng):
    return "!" + rng.choice(COMMENTS)


def line_end(rng, comments=True):
    """The end of a line inside a group, behind a comment or not, with empty lines and lines of comment."""
    end = blanks(rng) + (comment(rng) if comments and rng.random() < 0.2 else "") + "\n"
    while rng.random() < 0.15:
        end += blanks(rng) + (comment(rng) if rng.random() < 0.5 else "") + "\n"
    return end + blanks(rng)


def gap(rng, comments=True):
    """What separates two values or items without a comma. gfortran misreads comments behind '=', nulls and logicals."""
    return line_end(rng, comments) if rng.random() < 0.4 else rng.choice(BLANKS)


def comma(rng):
    """gfortran takes a comment behind a comma for one value more."""
    mark = "," if rng.random() < 0.97 else ";"
    return blanks(rng) + mark + (line_end(rng, comments=False) if rng.random() < 0.3 else blanks(rng))
