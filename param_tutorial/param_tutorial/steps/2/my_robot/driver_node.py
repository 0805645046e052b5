def main():
    print('Hi from my_robot.')


if __name__ == '__main__':
    main()
