//! Finds the C library: in the folder that CIRCUMSPECT_PREFIX names, else as pkg-config says. With
//! CIRCUMSPECT_STATIC=1 it is an archive.
use std::env;
use std::fs;
use std::path::PathBuf;
use std::process::{exit, Command};

fn give_up(found: &str) -> ! {
    eprintln!(
        "circumspect: expected the C library libcircumspect and its circumspect-c.pc, found {found}: install it \
         (Debian: libcircumspect-dev, or `cmake --install build/release --component harness` in the sources of \
         Circumspect), and set CIRCUMSPECT_PREFIX to the prefix if it is not among those of the system"
    );
    exit(1)
}

/// Puts the shared library where cargo looks for it when it runs the tests of whoever has this crate:
/// the run path is one of the crate's own tests alone, and a prefix is no folder of the system.
fn lay_down(folder: &str) {
    let out = PathBuf::from(env::var("OUT_DIR").expect("cargo names a folder"));
    for file in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = file.file_name().to_string_lossy().into_owned();
        if !name.starts_with("libcircumspect.") || name.ends_with(".a") {
            continue;
        }
        println!("cargo:rerun-if-changed={}", file.path().display());
        if let Err(error) = fs::copy(file.path(), out.join(&name)) {
            give_up(&format!("{name} in {folder}, which cannot be copied ({error})"));
        }
    }
    println!("cargo:rustc-link-search=native={}", out.display());
}

/// The words of what pkg-config says, which has a backslash before a space within a name.
fn words(said: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut characters = said.chars();
    while let Some(character) = characters.next() {
        let word = words.last_mut().expect("there is one from the beginning");
        match character {
            '\\' => word.extend(characters.next()),
            _ if character.is_whitespace() => words.push(String::new()),
            _ => word.push(character),
        }
    }
    words
}

fn main() {
    // docs.rs links nothing, and has no C library.
    if env::var_os("DOCS_RS").is_some() {
        return;
    }
    for name in ["CIRCUMSPECT_PREFIX", "CIRCUMSPECT_STATIC", "PKG_CONFIG_PATH"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    let is_static = env::var("CIRCUMSPECT_STATIC").map_or(false, |value| value == "1");
    let mut pkg_config = Command::new("pkg-config");
    pkg_config.args(["--libs", "circumspect-c"]);
    if is_static {
        pkg_config.arg("--static");
    }
    if let Ok(prefix) = env::var("CIRCUMSPECT_PREFIX") {
        let machine = Command::new("gcc").arg("-print-multiarch").output();
        let machine = machine.map_or(String::new(), |said| String::from_utf8_lossy(&said.stdout).trim().to_string());
        let folders = ["lib".to_string(), "lib64".to_string(), format!("lib/{machine}")];
        let paths: Vec<_> = folders.iter().map(|folder| format!("{prefix}/{folder}/pkgconfig")).collect();
        pkg_config.env("PKG_CONFIG_PATH", paths.join(":"));
    }
    let said = match pkg_config.output() {
        Err(error) => give_up(&format!("no pkg-config ({error})")),
        Ok(said) if !said.status.success() => give_up(String::from_utf8_lossy(&said.stderr).trim()),
        Ok(said) => String::from_utf8_lossy(&said.stdout).into_owned(),
    };
    for word in words(&said) {
        if let Some(folder) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={folder}");
            if !is_static {
                println!("cargo:rustc-link-arg=-Wl,-rpath,{folder}");
                lay_down(folder);
            }
        } else if let Some(library) = word.strip_prefix("-l") {
            let kind = if is_static && library == "circumspect" { "static=" } else { "" };
            println!("cargo:rustc-link-lib={kind}{library}");
        }
    }
}
