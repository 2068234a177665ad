#include "simcore/base/posix_file.h"

#include <sys/stat.h>

namespace clothlab {

bool isUsableName(const std::string& path) {
    return !path.empty() && path.find('\0') == std::string::npos;
}

Words describeUnusableName() {
    return {"is not a name of a file", "give a name that is not empty and holds no zero byte"};
}

Words describe(int error) {
    switch (error) {
    case ENOENT:
        return {"there is no such file or folder", "check its name and the folder it should be in"};
    case ENOTDIR:
        return {"a part of its path is a file, not a folder", "check the path"};
    case EACCES:
    case EPERM:
        return {"its permissions do not allow it", "change the permissions or choose another place"};
    case EROFS:
        return {"it is on a disk that can only be read", "choose another place"};
    case ELOOP:
        return {"its symbolic links go in a circle", "correct the links"};
    case ENAMETOOLONG:
        return {"its name is too long", "choose a shorter name"};
    case ENOSPC:
    case EDQUOT:
        return {"the disk is full", "free some space or choose another disk"};
    case EFBIG:
        return {"it grows larger than the disk allows", "choose another disk"};
    case EMFILE:
    case ENFILE:
        return {"too many files are open", "close some and try again"};
    case EIO:
        return {"the disk reports a fault", "check the disk and try again"};
    default:
        return {"the system refuses it (error " + std::to_string(error) + ")",
                "try again or choose another place"};
    }
}

std::string sentence(const Words& words) {
    return words.message + "; " + words.remedy;
}

Words describeKind(mode_t mode) {
    if (S_ISDIR(mode))
        return {"is a folder, not a file", "name a file in it"};
    return {"is a pipe, socket or device, not a file", "name an ordinary file"};
}

} // namespace clothlab
