//! Names for folders of results, after the files they come from.

use std::path::Path;

/// The name of a folder, or that of a file without its ending: `v1.2` for the folder `v1.2`, `radii` for `radii.toml`.
pub(crate) fn name_of(path: &Path) -> Option<String> {
    // A folder such as `.` has a name only when it is written out.
    let path = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let name = if path.is_dir() {
        path.file_name()
    } else {
        path.file_stem()
    };
    name.map(|n| n.to_string_lossy().into_owned())
}

/// [`name_of`] a file; that of its folder where the file is called `usual` and so says nothing.
pub(crate) fn telling_name(file: &Path, usual: &str) -> Option<String> {
    match name_of(file) {
        Some(name) if file.is_dir() || name != usual => Some(name),
        _ => {
            let folder = file.parent().filter(|p| !p.as_os_str().is_empty());
            name_of(folder.unwrap_or(Path::new(".")))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_in_the_name_of_a_folder_are_kept() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join("v1.2");
        std::fs::create_dir(&folder).unwrap();
        let (usual, other) = (folder.join("case.toml"), folder.join("near.toml"));
        std::fs::write(&usual, "").unwrap();
        std::fs::write(&other, "").unwrap();
        assert_eq!(telling_name(&folder, "case").unwrap(), "v1.2");
        assert_eq!(telling_name(&usual, "case").unwrap(), "v1.2");
        assert_eq!(telling_name(&other, "case").unwrap(), "near");
    }
}
