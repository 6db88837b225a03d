"""The required properties of every installed ELF file; each is a function that returns its complaints."""
import collections

from elf import (DF_1_NOW, DF_1_PIE, DF_BIND_NOW, DF_TEXTREL, DT_FINI, DT_FLAGS, DT_FLAGS_1, DT_INIT,
                 DT_TEXTREL, EM_X86_64, ET_DYN, IBT, PF_W, PF_X, PT_GNU_RELRO, PT_GNU_STACK, PT_LOAD,
                 SHF_ALLOC, SHF_EXEC, SHSTK, SHT_DYNSYM, STT_FUNC, STT_IFUNC)

LANDING_PAD = bytes.fromhex('f30f1efa')  # endbr64
# Functions of libc that have a checked twin and a buffer whose size may be known.
FORTIFIABLE = {'memcpy', 'memmove', 'memset', 'strcpy', 'strcat', 'strncpy', 'strncat', 'sprintf',
               'snprintf', 'vsprintf', 'vsnprintf', 'printf', 'fprintf', 'vprintf', 'vfprintf',
               'read', 'pread', 'recv', 'fgets', 'fread', 'realpath', 'readlink', 'getcwd'}
# Imports of the start-up files.
OF_START_UP = {'__cxa_finalize', '__gmon_start__', '_ITM_deregisterTMCloneTable',
               '_ITM_registerTMCloneTable', '__libc_start_main'}
# Single pointers that may be writable, and their owners; and numbers that only look like addresses.
WRITABLE_POINTERS = {
    '_ZN10__cxxabiv119__terminate_handlerE': 'std::set_terminate of the C++ library writes it',
    '_ZN10__cxxabiv120__unexpected_handlerE': 'std::set_unexpected of the C++ library writes it',
    '_ZN7arbiter12_GLOBAL__N_115g_standardErrorE': 'an inode, which may be where a program at a fixed address lies',
    '_ZN7arbiter12_GLOBAL__N_16g_fileE': 'likewise, of the log',
    'DW.ref.__gxx_personality_v0': "the compiler's own, for the unwinder; it is not relro in GCC 12",
}
# Files that consist mostly of foreign code. Only their exports need landing pads, and only Arbiter's part of their data
# must have no writable functions.
OTHERS = {'libarbiter_jit.so': 'LLVM, which Debian builds without landing pads, and which registers '
                               'its targets and options in data of its own'}
# Qt writes its type numbers into the type descriptions, functions included: one for each class with signals, only in
# programs. The layer has no Qt.
OF_QT = '_ZN9QtPrivate25QMetaTypeInterfaceWrapper'
# Data of static libraries may contain functions; this many are a table.
OTHERS_TABLE = 8


def is_writable_table(library, name, count):
    """True if it is a fault that a datum has so many writable pointers to functions. A place that belongs to no datum
    has its section's name, with a plus."""
    if name in WRITABLE_POINTERS or (name.startswith(OF_QT) and library == 'arbiter-builder'):
        return False
    return ('arbiter' in name or '+' in name or
            (count >= OTHERS_TABLE and library not in OTHERS))


def is_program(elf):
    return bool(elf.dynamic.get(DT_FLAGS_1, 0) & DF_1_PIE) or '__libc_start_main' in elf.imports


def has_code(elf):
    return any(s.flags & PF_X for s in elf.of_type(PT_LOAD))


def calls_out(elf):
    return bool(elf.imports - OF_START_UP)


def full_relro(elf):
    if not elf.of_type(PT_GNU_RELRO):
        return ['no PT_GNU_RELRO: what the loader fills stays writable (-z relro)']
    return []


def binds_now(elf):
    if elf.dynamic.get(DT_FLAGS, 0) & DF_BIND_NOW or elf.dynamic.get(DT_FLAGS_1, 0) & DF_1_NOW:
        return []
    return ['functions are bound when first called, so their table stays writable (-z now)']


def stack_holds_no_code(elf):
    stack = elf.of_type(PT_GNU_STACK)
    if not stack:
        return ['no PT_GNU_STACK: the stack would be executable (-z noexecstack)']
    return ['the stack would be executable (-z noexecstack)'] if stack[0].flags & PF_X else []


def nothing_is_writable_and_code(elf):
    return [f'the segment at {s.address:#x} is writable and executable'
            for s in elf.of_type(PT_LOAD) if s.flags & PF_W and s.flags & PF_X]


def code_lies_apart(elf):
    """Requires no data between instructions, so that read-only data is not executable."""
    return [f'{section.name} lies in an executable segment (-z separate-code)'
            for section in elf.sections if section.flags & SHF_ALLOC and section.size and
            not section.flags & SHF_EXEC and elf.is_code(section.address)]


def text_is_not_relocated(elf):
    if DT_TEXTREL in elf.dynamic or elf.dynamic.get(DT_FLAGS, 0) & DF_TEXTREL:
        return ['code is written when it is loaded (-fPIC, -fPIE)']
    return []


def lies_anywhere(elf):
    return [] if elf.type == ET_DYN else ['loaded at one fixed address (-fPIE, -pie)']


def guards_stacks(elf):
    if not has_code(elf) or not calls_out(elf) or '__stack_chk_fail' in elf.imports:
        return []
    return ['no function checks its stack (-fstack-protector-strong)']


def checks_buffers(elf):
    plain = sorted(elf.imports & FORTIFIABLE)
    if not plain or any(name.endswith('_chk') for name in elf.imports - {'__stack_chk_fail'}):
        return []
    return [f'no buffer is checked, and these are called: {", ".join(plain)} (_FORTIFY_SOURCE)']


def functions_are_not_written(elf):
    """Checks data that is filled at load time; inside.py checks a process that has run."""
    counts = collections.Counter(elf.object_at(pointer.place) for pointer in elf.code_pointers()
                                 if elf.stays_writable(pointer.place))
    return [f'{name} has {count} pointers to functions and may be written'
            for name, count in counts.items() if is_writable_table(elf.name, name, count)]


def control_flow_is_marked(elf):
    if elf.machine != EM_X86_64 or not has_code(elf):
        return []
    have = elf.x86_features()
    complaints = [] if have & SHSTK else ['not marked for shadow stacks (-fcf-protection, -z shstk)']
    if not is_program(elf) and not have & IBT and elf.name not in OTHERS:
        complaints.append('not marked for indirect branch tracking (-fcf-protection, -z ibt)')
    return complaints


def control_flow_lands_on_pads(elf):
    """Requires a landing pad at the start of functions that are called by address, whatever the mark says."""
    if elf.machine != EM_X86_64:
        return []
    whole = elf.name not in OTHERS
    entries = {p.target: elf.object_at(p.place) for p in elf.code_pointers()
               if p.target is not None and whole}
    entries.update((s.value, s.name) for s in elf.symbols(SHT_DYNSYM)
                   if s.section and s.type in (STT_FUNC, STT_IFUNC))
    if not is_program(elf) and whole:
        entries.update((elf.dynamic[tag], name) for tag, name in
                       ((DT_INIT, 'DT_INIT'), (DT_FINI, 'DT_FINI')) if tag in elf.dynamic)
    start_up = {elf.dynamic.get(DT_INIT), elf.dynamic.get(DT_FINI), elf.entry}
    return [f'the function at {address:#x} ({name}) begins without endbr64'
            for address, name in sorted(entries.items())
            if elf.bytes_at(address, 4) != LANDING_PAD and
            not (is_program(elf) and address in start_up)]


PROPERTIES = [full_relro, binds_now, stack_holds_no_code, nothing_is_writable_and_code,
              code_lies_apart, text_is_not_relocated, lies_anywhere, guards_stacks, checks_buffers,
              functions_are_not_written, control_flow_is_marked, control_flow_lands_on_pads]
# These depend on the compiler's options, which a tree has with -Dhardening=true.
COMPILED = {check.__name__ for check in (guards_stacks, checks_buffers, control_flow_is_marked,
                                         control_flow_lands_on_pads)}


def complaints(elf):
    """Returns [(name of the property, text)]."""
    return [(check.__name__, text) for check in PROPERTIES for text in check(elf)]
