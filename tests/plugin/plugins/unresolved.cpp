int defined_nowhere();
int some_function() { return defined_nowhere(); }
