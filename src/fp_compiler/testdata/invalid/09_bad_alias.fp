!!ARBfp1.0
TEMP a;
ALIAS b = c;
ALIAS d = fragment.color;
ALIAS a = a;
END
