plugins { application }

application {
    mainClass = "experiment.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}

// Reports name this version and commit.
tasks.jar { manifest { attributes("Implementation-Version" to "$version, of an unknown commit") } }

// As ./argo runs it: a spectator presses Enter, and paths begin in the folder in which Gradle was called.
tasks.named<JavaExec>("run") {
    standardInput = System.`in`
    workingDir = rootDir
}
