plugins { application }

application {
    mainClass = "experiment.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}

// The reports contain this version and commit.
tasks.jar { manifest { attributes("Implementation-Version" to "$version, of an unknown commit") } }

// As with ./argo, a spectator can press Enter, and relative paths begin in the folder in which Gradle was called.
tasks.named<JavaExec>("run") {
    standardInput = System.`in`
    workingDir = rootDir
}
