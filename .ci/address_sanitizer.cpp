// Linked into every program that AddressSanitizer checks.
#include <csignal>
#include <unistd.h>

// A leak in a library that was unloaded cannot be told by the library's name and so not be suppressed
// (.ci/lsan.supp); so none is unloaded.
extern "C" int dlclose(void*) {
    return 0;
}

// A program that hangs says where, before the test is ended from outside: no log would tell.
extern "C" void __sanitizer_print_stack_trace();

namespace {

constexpr unsigned kPatience = 90; // s

void sayWhere(int) {
    static const char words[] = "\nStill running; the main thread is here:\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, words, sizeof words - 1);
    __sanitizer_print_stack_trace();
}

[[maybe_unused]] const bool watched = [] {
    struct sigaction action {};
    action.sa_handler = sayWhere;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    alarm(kPatience);
    return true;
}();

} // namespace
