plugins { `java-library` }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    api(project(":argo-recording")) // replayed("drive.mcap")
    testImplementation(libs.jason)
    testImplementation(libs.mockk)
}
