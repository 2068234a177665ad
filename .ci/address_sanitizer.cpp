// Linked into every program that AddressSanitizer checks. A leak in a library that was unloaded cannot be told by the
// library's name and so not be suppressed (.ci/lsan.supp); so none is unloaded.
extern "C" int dlclose(void*) {
    return 0;
}
