# the whole
schema-json-invalid =
    .found = JSON that does not parse ({ $error })
    .expected = JSON
schema-json-type =
    .found = { $input }
    .expected = JSON as text
schema-recursion-loop =
    .found = something that contains itself
    .expected = an end
schema-recursion-depth-exceeded =
    .found = something nested too deep
    .expected = fewer levels
schema-missing =
    .found = no such key
    .expected = it
schema-extra-forbidden =
    .found = an unknown key
    .expected = a key of the format
schema-invalid-key =
    .found = a key that is no text
    .expected = keys that are texts
schema-model-type =
    .found = { $input }
    .expected = a table of keys and values
schema-model-attributes-type =
    .found = { $input }
    .expected = a table of keys and values
schema-dataclass-type =
    .found = { $input }
    .expected = a table of keys and values
schema-named-tuple-type =
    .found = { $input }
    .expected = a list or a table
schema-dict-type =
    .found = { $input }
    .expected = a table of keys and values
schema-mapping-type =
    .found = { $input }
    .expected = a table of keys and values
schema-none-required =
    .found = { $input }
    .expected = null
# numbers
schema-greater-than =
    .found = { $input }
    .expected = greater than { SIGNIFICANT($gt, digits: 12) }
schema-greater-than-equal =
    .found = { $input }
    .expected = greater than or equal to { SIGNIFICANT($ge, digits: 12) }
schema-less-than =
    .found = { $input }
    .expected = less than { SIGNIFICANT($lt, digits: 12) }
schema-less-than-equal =
    .found = { $input }
    .expected = less than or equal to { SIGNIFICANT($le, digits: 12) }
schema-multiple-of =
    .found = { $input }
    .expected = a multiple of { SIGNIFICANT($multiple_of, digits: 12) }
schema-finite-number =
    .found = { $input }
    .expected = a finite number
schema-bool-type =
    .found = { $input }
    .expected = true or false
schema-bool-parsing =
    .found = { $input }
    .expected = true or false
schema-int-type =
    .found = { $input }
    .expected = a whole number
schema-int-parsing =
    .found = { $input }
    .expected = a whole number
schema-int-parsing-size =
    .found = { $input }
    .expected = a whole number with fewer digits
schema-int-from-float =
    .found = { $input }
    .expected = a whole number
schema-float-type =
    .found = { $input }
    .expected = a valid number
schema-float-parsing =
    .found = { $input }
    .expected = a valid number
schema-decimal-type =
    .found = { $input }
    .expected = a decimal number
schema-decimal-parsing =
    .found = { $input }
    .expected = a decimal number
schema-decimal-max-digits =
    .found = { $input }
    .expected = at most { $max_digits ->
        [one] { $max_digits } digit
       *[other] { $max_digits } digits
    }
schema-decimal-max-places =
    .found = { $input }
    .expected = at most { $decimal_places ->
        [one] { $decimal_places } decimal place
       *[other] { $decimal_places } decimal places
    }
schema-decimal-whole-digits =
    .found = { $input }
    .expected = at most { $whole_digits ->
        [one] { $whole_digits } digit before the decimal point
       *[other] { $whole_digits } digits before the decimal point
    }
# lists
schema-too-short =
    .found = { $input }
    .expected = at least { $min_length ->
        [one] { $min_length } item
       *[other] { $min_length } items
    }
schema-too-long =
    .found = { $input }
    .expected = at most { $max_length ->
        [one] { $max_length } item
       *[other] { $max_length } items
    }
schema-iterable-type =
    .found = { $input }
    .expected = a list
schema-iteration-error =
    .found = a list that cannot be read ({ $error })
    .expected = a list
schema-list-type =
    .found = { $input }
    .expected = a list
schema-tuple-type =
    .found = { $input }
    .expected = a list
schema-deque-type =
    .found = { $input }
    .expected = a list
schema-set-type =
    .found = { $input }
    .expected = a list
schema-frozen-set-type =
    .found = { $input }
    .expected = a list
schema-set-item-not-hashable =
    .found = { $input }
    .expected = a single value
# texts
schema-string-type =
    .found = { $input }
    .expected = a text
schema-string-unicode =
    .found = bytes that are no text
    .expected = text in UTF-8
schema-string-too-short =
    .found = { $input }
    .expected = at least { $min_length ->
        [one] { $min_length } character
       *[other] { $min_length } characters
    }
schema-string-too-long =
    .found = { $input }
    .expected = at most { $max_length ->
        [one] { $max_length } character
       *[other] { $max_length } characters
    }
schema-string-pattern-mismatch =
    .found = { $input }
    .expected = a text of the pattern { $pattern }
schema-string-not-ascii =
    .found = { $input }
    .expected = ASCII characters alone
schema-enum =
    .found = { $input }
    .expected = one of { $expected }
schema-literal-error =
    .found = { $input }
    .expected = one of { $expected }
schema-bytes-type =
    .found = { $input }
    .expected = bytes
schema-bytes-too-short =
    .found = { $input }
    .expected = at least { $min_length ->
        [one] { $min_length } byte
       *[other] { $min_length } bytes
    }
schema-bytes-too-long =
    .found = { $input }
    .expected = at most { $max_length ->
        [one] { $max_length } byte
       *[other] { $max_length } bytes
    }
schema-bytes-invalid-encoding =
    .found = bytes that are not { $encoding } ({ $encoding_error })
    .expected = { $encoding }
# what a check of Heft's own says
schema-value-error =
    .found = { $input }
    .expected = { $error }
schema-assertion-error =
    .found = { $input }
    .expected = { $error }
# dates and times
schema-date-type =
    .found = { $input }
    .expected = a date, such as 2026-01-31
schema-date-parsing =
    .found = { $input }
    .expected = a date, such as 2026-01-31
schema-date-from-datetime-parsing =
    .found = { $input }
    .expected = a date, such as 2026-01-31
schema-date-from-datetime-inexact =
    .found = { $input }
    .expected = a date without a time of day
schema-date-past =
    .found = { $input }
    .expected = a date in the past
schema-date-future =
    .found = { $input }
    .expected = a date in the future
schema-time-type =
    .found = { $input }
    .expected = a time of day, such as 12:00:00
schema-time-parsing =
    .found = { $input }
    .expected = a time of day, such as 12:00:00
schema-datetime-type =
    .found = { $input }
    .expected = a date with time, such as 2026-01-31T12:00:00Z (ISO 8601)
schema-datetime-parsing =
    .found = { $input }
    .expected = a date with time, such as 2026-01-31T12:00:00Z (ISO 8601)
schema-datetime-object-invalid =
    .found = { $input }
    .expected = a date with time, such as 2026-01-31T12:00:00Z (ISO 8601)
schema-datetime-from-date-parsing =
    .found = { $input }
    .expected = a date with time, such as 2026-01-31T12:00:00Z (ISO 8601)
schema-datetime-past =
    .found = { $input }
    .expected = a time in the past
schema-datetime-future =
    .found = { $input }
    .expected = a time in the future
schema-timezone-naive =
    .found = { $input }
    .expected = a time without a time zone
schema-timezone-aware =
    .found = { $input }
    .expected = a time with its time zone
schema-timezone-offset =
    .found = an offset of { $tz_actual } s from UTC
    .expected = { $tz_expected } s
schema-time-delta-type =
    .found = { $input }
    .expected = a duration, such as PT1H30M (ISO 8601)
schema-time-delta-parsing =
    .found = { $input }
    .expected = a duration, such as PT1H30M (ISO 8601)
# one of several kinds
schema-union-tag-invalid =
    .found = the kind { $tag }
    .expected = one of { $expected_tags }
schema-union-tag-not-found =
    .found = no kind
    .expected = one named by { $discriminator }
# addresses and identifiers
schema-url-type =
    .found = { $input }
    .expected = a URL
schema-url-parsing =
    .found = { $input }
    .expected = a URL
schema-url-syntax-violation =
    .found = { $input }
    .expected = a URL
schema-url-too-long =
    .found = { $input }
    .expected = at most { $max_length ->
        [one] { $max_length } character
       *[other] { $max_length } characters
    }
schema-url-scheme =
    .found = { $input }
    .expected = a URL that begins with one of { $expected_schemes }
schema-uuid-type =
    .found = { $input }
    .expected = a UUID
schema-uuid-parsing =
    .found = { $input }
    .expected = a UUID
schema-uuid-version =
    .found = { $input }
    .expected = a UUID of version { $expected_version }
# for what nobody has thought of, and for what is not told
schema-other =
    .found = { $input }
    .expected = a value that fits ({ $type })
schema-hidden = a value that is not shown
