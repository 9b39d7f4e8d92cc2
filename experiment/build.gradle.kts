plugins { application }

application {
    mainClass = "experiment.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}

// The reports contain this version and the commit.
tasks.jar { manifest { attributes("Implementation-Version" to "$version, of an unknown commit") } }

// As with ./argo, a user can press Enter, and relative paths start at the root of the sources.
tasks.named<JavaExec>("run") {
    standardInput = System.`in`
    workingDir = rootDir
}
