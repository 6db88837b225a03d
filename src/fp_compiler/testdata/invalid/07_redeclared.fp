!!ARBfp1.0
TEMP a, b;
PARAM b = 1;
ALIAS a = b;
END
